#pragma once

#include "engine/core/result.h"
#include "engine/session/facts/facts.h"

#include <map>
#include <string>
#include <string_view>

namespace carina
{

/// What a person types to come into a session in one role: 50 random bits as ten characters of
/// base32 without lookalikes (no I, L, O or U).
class JoinCode
{
public:
    static constexpr std::size_t kCharacters = 10;

    [[nodiscard]] static JoinCode random();
    /// In any case, with or without the dash or blanks; I and L are taken for 1, O for 0.
    /// @returns WrongCode for anything but ten of the alphabet's characters.
    [[nodiscard]] static Result<JoinCode> parse(std::string_view typed);

    /// As it is shown: XXXXX-XXXXX.
    [[nodiscard]] std::string text() const;
    /// The ten characters, as keys are derived from them.
    [[nodiscard]] const std::string& characters() const { return m_characters; }

    friend bool operator==(const JoinCode&, const JoinCode&) = default;

private:
    explicit JoinCode(std::string characters) : m_characters{std::move(characters)} {}

    std::string m_characters;
};

/// One for each role, independent of each other.
using JoinCodes = std::map<Role, JoinCode>;

} // namespace carina
