#pragma once

#include "engine/core/errc.h"

#include <string>
#include <tl/expected.hpp>
#include <utility>

namespace carina
{

/// A recoverable failure: its kind, and a detail (which file, which value) for the person who
/// corrects it. The sentence shown to the user is made in models/errors/error_text.
struct Error {
    Errc code;
    std::string detail;

    friend bool operator==(const Error&, const Error&) = default;
};

/// A value, or the reason why there is none. For failures of input, files, network, devices and
/// geometry; programming errors are caught by CARINA_EXPECTS.
template <class T> using Result = tl::expected<T, Error>;

/// `return fail(Errc::FileEmpty, path);`
[[nodiscard]] inline tl::unexpected<Error> fail(Errc code, std::string detail = {})
{
    return tl::unexpected<Error>(Error{code, std::move(detail)});
}

} // namespace carina
