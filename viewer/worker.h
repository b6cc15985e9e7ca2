// A thread for long computations beside the window: the last one that was asked for counts.
#pragma once

#include "diagnostics/result.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <utility>

namespace quartic::viewer {

// Asked from time to time whether the work is still wanted.
using Stop = std::function<bool()>;

template <class Value>
class Worker {
public:
    using Work = std::function<Value(const Stop&)>;

    // wake: called from the thread when a result can be taken.
    explicit Worker(std::function<void()> wake) : wake_(std::move(wake)) {
        thread_ = std::thread([this] { run(); });
    }
    Worker(const Worker&) = delete;
    Worker& operator=(const Worker&) = delete;
    ~Worker() {
        {
            const std::scoped_lock lock(mutex_);
            forget();
            is_ending_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }

    // Whatever was begun before is no longer wanted.
    void begin(Work work) {
        {
            const std::scoped_lock lock(mutex_);
            forget();
            next_ = std::move(work);
            is_busy_ = true;
        }
        changed_.notify_all();
    }
    void cancel() {
        const std::scoped_lock lock(mutex_);
        forget();
    }
    // From begin() until the result was taken.
    bool is_busy() const { return is_busy_; }
    std::optional<Result<Value>> take() {
        const std::scoped_lock lock(mutex_);
        std::optional<Result<Value>> taken = std::exchange(done_, std::nullopt);
        is_busy_ = is_busy_ && !taken;
        return taken;
    }

private:
    void forget() {
        ++wanted_;
        next_ = nullptr;
        done_.reset();
        is_busy_ = false;
    }

    static Result<Value> result_of(const Work& work, const Stop& stop) {
        try {
            return work(stop);
        } catch (const std::exception& exception) {  // out of memory
            return Error{ErrorKind::io, "", std::string("cannot be done: ") + exception.what()};
        }
    }

    void run() {
        std::unique_lock lock(mutex_);
        for (;;) {
            changed_.wait(lock, [this] { return is_ending_ || next_ != nullptr; });
            if (is_ending_) {
                return;
            }
            const Work work = std::exchange(next_, nullptr);
            const std::uint64_t own = wanted_;
            lock.unlock();
            Result<Value> result = result_of(work, [this, own] { return wanted_ != own; });
            lock.lock();
            if (wanted_ == own) {
                done_ = std::move(result);
                wake_();
            }
        }
    }

    std::function<void()> wake_;
    std::mutex mutex_;
    std::condition_variable changed_;
    Work next_;
    std::optional<Result<Value>> done_;
    std::atomic<std::uint64_t> wanted_{0};  // number of the computation that counts
    std::atomic<bool> is_busy_{false};
    bool is_ending_ = false;
    std::thread thread_;
};

}  // namespace quartic::viewer
