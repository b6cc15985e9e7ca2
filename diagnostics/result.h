// Failures as values: what went wrong, where, and what to do, or the result.
#pragma once

#include <string>
#include <utility>
#include <variant>

namespace quartic {

// The kinds differ in the exit code that the command line gives them.
enum class ErrorKind {
    bad_data,     // the bytes are not what they should be: 1
    usage,        // the call makes no sense: 2
    io,           // a file could not be read or written: 4
    no_opengl,    // no usable OpenGL: 5
    interrupted,  // cancelled by a signal or by the user
};

// Printed as one line: "where: message". The message says what was expected, what was found, and
// what to do.
struct Error {
    ErrorKind kind = ErrorKind::bad_data;
    std::string where;  // "pump.rvm, byte 18204, PRIM", or empty
    std::string message;
};

// Either a value or an Error. Check ok() before value() or error().
template <class Value>
class Result {
public:
    Result(Value value) : content_(std::in_place_index<0>, std::move(value)) {}
    Result(Error error) : content_(std::in_place_index<1>, std::move(error)) {}

    bool ok() const { return content_.index() == 0; }
    explicit operator bool() const { return ok(); }

    const Value& value() const& { return std::get<0>(content_); }
    Value& value() & { return std::get<0>(content_); }
    Value&& value() && { return std::get<0>(std::move(content_)); }
    const Error& error() const { return std::get<1>(content_); }

private:
    std::variant<Value, Error> content_;
};

struct Done {};
using Status = Result<Done>;

}  // namespace quartic
