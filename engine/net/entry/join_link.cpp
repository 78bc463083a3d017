#include "engine/net/entry/join_link.h"

#include "engine/net/discovery/addresses.h"
#include "engine/net/entry/psk_identity.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>

namespace carina
{
namespace
{

constexpr std::string_view kLinkBegin = "carina:join?";
constexpr std::string_view kBlanks = " \t\r\n";

enum LinkPart : std::size_t { Address, Port, RolePart, Code, Certificate, PartCount };
constexpr std::array<std::string_view, PartCount> kPartNames{"address", "port", "role", "code",
                                                             "certificate"};
using LinkParts = std::array<std::optional<std::string_view>, PartCount>;

std::string_view withoutBlanksAround(std::string_view text)
{
    const std::size_t first = text.find_first_not_of(kBlanks);
    if (first == text.npos)
        return {};
    return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

Result<LinkParts> takeApart(std::string_view query)
{
    LinkParts parts;
    while (!query.empty()) {
        const std::string_view part = query.substr(0, query.find('&'));
        query.remove_prefix(std::min(part.size() + 1, query.size()));
        const std::size_t equals = part.find('=');
        const auto name = std::ranges::find(kPartNames, part.substr(0, equals));
        if (equals == part.npos || name == kPartNames.end())
            return fail(Errc::WrongLink, "a part of it is unknown");
        auto& value = parts[static_cast<std::size_t>(name - kPartNames.begin())];
        if (value)
            return fail(Errc::WrongLink, "its " + std::string{*name} + " is there twice");
        value = part.substr(equals + 1);
    }
    return parts;
}

/// 0 for what is no port.
std::uint16_t portIn(std::string_view text)
{
    std::uint16_t port = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), port);
    return error == std::errc{} && end == text.data() + text.size() ? port : std::uint16_t{0};
}

} // namespace

std::string toText(const JoinLink& link)
{
    return std::string{kLinkBegin} + "address=" + link.address
           + "&port=" + std::to_string(link.port) + "&role=" + std::string{roleWord(link.role)}
           + "&code=" + link.code.text()
           + (link.certificate.empty() ? "" : "&certificate=" + link.certificate);
}

bool isMeantAsLink(std::string_view text)
{
    return withoutBlanksAround(text).starts_with(JoinLink::kScheme);
}

Result<JoinLink> joinLink(std::string_view text)
{
    text = withoutBlanksAround(text);
    if (!text.starts_with(kLinkBegin))
        return fail(Errc::WrongLink, "it does not begin with " + std::string{kLinkBegin});
    if (text.size() > JoinLink::kLongest)
        return fail(Errc::WrongLink, "it is too long");
    const auto parts = takeApart(text.substr(kLinkBegin.size()));
    if (!parts)
        return tl::unexpected(parts.error());
    const auto said = [&parts](LinkPart part) {
        return (*parts)[part].value_or(std::string_view{});
    };
    const std::string address{said(Address)};
    if (!isAddress(address))
        return fail(Errc::WrongLink, "it has no address");
    const std::uint16_t port = portIn(said(Port));
    if (port == 0)
        return fail(Errc::WrongLink, "it has no port");
    const auto role = roleOfWord(said(RolePart));
    if (!role || *role == Role::Instructor)
        return fail(Errc::WrongLink, "it is for neither a trainee nor an observer");
    const auto code = JoinCode::parse(said(Code));
    if (!code)
        return fail(Errc::WrongLink, "it has no code of ten letters and digits");
    const std::string certificate{said(Certificate)};
    if ((*parts)[Certificate] && !isHostName(certificate))
        return fail(Errc::WrongLink, "its certificate is for no host");
    return JoinLink{address, port, *role, *code, certificate};
}

} // namespace carina
