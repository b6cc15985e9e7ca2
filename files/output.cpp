// Writes beside the target and renames.
#include "files/output.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace quartic {
namespace {

constexpr std::size_t buffer_bytes_max = std::size_t{1} << 20;

Error io_error(const std::string& path, int code) {
    return {ErrorKind::io, path, std::string("cannot be written: ") + std::strerror(code)};
}

}  // namespace

Result<Output> Output::create(const std::string& path) {
    Output output;
    output.path_ = path;
    if (path == "-") {
        output.descriptor_ = STDOUT_FILENO;
        return output;
    }
    struct stat status {};
    const bool exists = ::stat(path.c_str(), &status) == 0;
    if (exists && !S_ISREG(status.st_mode)) {
        return Error{ErrorKind::io, path, "cannot be written: it is not a regular file"};
    }
    if (exists && ::access(path.c_str(), W_OK) != 0) {
        return io_error(path, errno);
    }
    const std::filesystem::path target(path);
    const std::string name = "." + target.filename().string() + ".XXXXXX";
    output.temporary_path_ = (target.parent_path() / name).string();
    output.descriptor_ = ::mkostemp(output.temporary_path_.data(), O_CLOEXEC);
    if (output.descriptor_ < 0) {
        const int code = errno;
        output.temporary_path_.clear();
        return io_error(path, code);
    }
    const mode_t mask = ::umask(0);
    ::umask(mask);
    ::fchmod(output.descriptor_, exists ? status.st_mode & 07777 : 0666 & ~mask);
    return output;
}

Output Output::to_memory(std::vector<std::byte>& bytes) {
    Output output;
    output.path_ = "-";
    output.memory_ = &bytes;
    return output;
}

Output::Output(Output&& other) noexcept
    : path_(std::move(other.path_)),
      temporary_path_(std::exchange(other.temporary_path_, {})),
      buffer_(std::move(other.buffer_)),
      memory_(std::exchange(other.memory_, nullptr)),
      descriptor_(std::exchange(other.descriptor_, -1)),
      failure_(other.failure_) {}

Output::~Output() {
    if (!temporary_path_.empty()) {
        ::close(descriptor_);
        ::unlink(temporary_path_.c_str());
    }
}

void Output::write(std::span<const std::byte> bytes) {
    buffer_.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (buffer_.size() >= buffer_bytes_max) {
        flush();
    }
}

void Output::flush() {
    if (memory_ != nullptr) {
        const auto added = std::as_bytes(std::span(buffer_));
        memory_->insert(memory_->end(), added.begin(), added.end());
        buffer_.clear();
        return;
    }
    std::size_t done = 0;
    while (done < buffer_.size() && failure_ == 0) {
        const ssize_t written = ::write(descriptor_, buffer_.data() + done, buffer_.size() - done);
        if (written >= 0) {
            done += static_cast<std::size_t>(written);
        } else if (errno != EINTR) {
            failure_ = errno;
        }
    }
    buffer_.clear();
}

Status Output::commit() {
    flush();
    if (path_ == "-") {
        return failure_ == 0 ? Status(Done{}) : Status(io_error("standard output", failure_));
    }
    if (failure_ == 0 && ::fsync(descriptor_) != 0) {
        failure_ = errno;
    }
    if (failure_ == 0 && ::rename(temporary_path_.c_str(), path_.c_str()) != 0) {
        failure_ = errno;
    }
    if (failure_ != 0) {
        return io_error(path_, failure_);
    }
    ::close(descriptor_);
    temporary_path_.clear();
    return Done{};
}

Status write_file(const std::string& path, std::span<const std::byte> bytes) {
    Result<Output> output = Output::create(path);
    if (!output) {
        return output.error();
    }
    output.value().write(bytes);
    return output.value().commit();
}

}  // namespace quartic
