#include "engine/net/entry/psk_identity.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace carina
{
namespace
{

constexpr std::string_view kNewcomer = "new";
constexpr std::size_t kSessionIdDigits = 32;

} // namespace

std::string_view roleWord(Role role)
{
    switch (role) {
    case Role::Instructor:
        return "instructor";
    case Role::Trainee:
        return "trainee";
    case Role::Observer:
        break;
    }
    return "observer";
}

std::optional<Role> roleOfWord(std::string_view word)
{
    for (const Role role : {Role::Instructor, Role::Trainee, Role::Observer})
        if (word == roleWord(role))
            return role;
    return std::nullopt;
}

bool isSessionId(std::string_view text)
{
    return text.size() == kSessionIdDigits && std::ranges::all_of(text, [](char c) {
               return (c >= '0' && c <= '9') || (c >= 'a' && c <= 'f');
           });
}

std::string toText(const PskIdentity& identity)
{
    const auto& participant = identity.who.participant;
    return std::string{roleWord(identity.who.role)} + ':' + identity.sessionId + ':'
           + (participant ? std::to_string(participant->value) : std::string{kNewcomer});
}

std::optional<PskIdentity> pskIdentity(std::string_view text)
{
    const std::size_t first = text.find(':');
    const std::size_t second = text.find(':', first == text.npos ? first : first + 1);
    if (second == text.npos)
        return std::nullopt;
    const auto role = roleOfWord(text.substr(0, first));
    PskIdentity identity{{role.value_or(Role::Observer), std::nullopt},
                         std::string{text.substr(first + 1, second - first - 1)}};
    const std::string_view last = text.substr(second + 1);
    if (last != kNewcomer) {
        ParticipantId id{};
        std::from_chars(last.data(), last.data() + last.size(), id.value);
        identity.who.participant = id;
    }
    // One spelling each: what does not come out as it went in is none.
    if (!role || !isSessionId(identity.sessionId) || toText(identity) != text)
        return std::nullopt;
    return identity;
}

} // namespace carina
