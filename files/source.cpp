// Maps a file, or reads standard input.
#include "files/source.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace quartic {
namespace {

Error io_error(const std::string& path, const std::string& what) {
    return {ErrorKind::io, path, what};
}

Result<std::vector<std::byte>> read_all(int descriptor, const std::string& path) {
    std::vector<std::byte> bytes;
    std::size_t used = 0;
    for (;;) {
        bytes.resize(used + (std::size_t{1} << 20));
        const ssize_t got = ::read(descriptor, bytes.data() + used, bytes.size() - used);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got < 0) {
            return io_error(path, std::string("cannot be read: ") + std::strerror(errno));
        }
        if (got == 0) {
            bytes.resize(used);
            return bytes;
        }
        used += static_cast<std::size_t>(got);
    }
}

// Closes the descriptor when the scope ends.
struct Descriptor {
    int number;
    ~Descriptor() { ::close(number); }
};

}  // namespace

Result<Source> Source::open(const std::string& path) {
    Source source;
    source.path_ = path;
    if (path == "-") {
        Result<std::vector<std::byte>> bytes = read_all(STDIN_FILENO, "standard input");
        if (!bytes) {
            return bytes.error();
        }
        return from_bytes("standard input", std::move(bytes).value());
    }
    // O_NONBLOCK: opening a FIFO must not wait for a writer.
    const int number = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (number < 0) {
        return io_error(path, std::string("cannot be opened: ") + std::strerror(errno));
    }
    const Descriptor descriptor{number};
    struct stat status {};
    if (::fstat(number, &status) != 0) {
        return io_error(path, std::string("cannot be examined: ") + std::strerror(errno));
    }
    if (S_ISDIR(status.st_mode)) {
        return io_error(path, "expected a file, found a directory; name a file in it");
    }
    if (!S_ISREG(status.st_mode)) {
        return io_error(
            path, "expected a regular file, found a device or pipe; use - for standard input");
    }
    const auto size = static_cast<std::size_t>(status.st_size);
    if (size == 0) {
        return source;
    }
    void* mapping = ::mmap(nullptr, size, PROT_READ, MAP_PRIVATE, number, 0);
    if (mapping == MAP_FAILED) {
        return io_error(path, std::string("cannot be mapped: ") + std::strerror(errno));
    }
    source.mapping_ = mapping;
    source.bytes_ = {static_cast<const std::byte*>(mapping), size};
    return source;
}

Source Source::from_bytes(std::string name, std::vector<std::byte> bytes) {
    Source source;
    source.path_ = std::move(name);
    source.owned_ = std::move(bytes);
    source.bytes_ = source.owned_;
    return source;
}

Source::Source(Source&& other) noexcept {
    *this = std::move(other);
}

Source& Source::operator=(Source&& other) noexcept {
    std::swap(path_, other.path_);
    std::swap(owned_, other.owned_);
    std::swap(bytes_, other.bytes_);
    std::swap(mapping_, other.mapping_);
    return *this;
}

Source::~Source() {
    if (mapping_ != nullptr) {
        ::munmap(mapping_, bytes_.size());
    }
}

}  // namespace quartic
