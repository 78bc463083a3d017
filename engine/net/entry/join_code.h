#pragma once

#include "engine/core/result.h"
#include "engine/session/facts/facts.h"

#include <map>
#include <string>
#include <string_view>

namespace carina
{

/// The code that a person types to join a session in one role: 50 random bits as ten characters of
/// base32 without I, L, O and U, which are easily confused.
class JoinCode
{
public:
    static constexpr std::size_t kCharacters = 10;

    [[nodiscard]] static JoinCode random();
    /// Accepts upper and lower case, with or without the dash or blanks; I and L are read as 1, O
    /// as 0.
    /// @returns WrongCode for anything but ten characters of the alphabet.
    [[nodiscard]] static Result<JoinCode> parse(std::string_view typed);

    /// The code as it is shown: XXXXX-XXXXX.
    [[nodiscard]] std::string text() const;
    /// The ten characters, from which keys are derived.
    [[nodiscard]] const std::string& characters() const { return m_characters; }

    friend bool operator==(const JoinCode&, const JoinCode&) = default;

private:
    explicit JoinCode(std::string characters) : m_characters{std::move(characters)} {}

    std::string m_characters;
};

/// One code for each role, chosen independently.
using JoinCodes = std::map<Role, JoinCode>;

} // namespace carina
