#pragma once

namespace carina
{

/// A visitor of a variant, made of one function for each kind.
template <class... Functions> struct Overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions> Overloaded(Functions...) -> Overloaded<Functions...>;

} // namespace carina
