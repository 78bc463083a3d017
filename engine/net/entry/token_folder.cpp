#include "engine/net/entry/token_folder.h"

#include "engine/io/files/whole_file.h"

#include <QCryptographicHash>

#include <algorithm>
#include <charconv>

namespace carina
{
namespace
{

constexpr const char* kTokenEnding = ".token";

} // namespace

TokenFolder::TokenFolder(std::filesystem::path folder, Role role, std::string name)
    : m_folder{std::move(folder)}, m_role{role}, m_name{std::move(name)}
{
}

std::optional<TokenFolder::Token> TokenFolder::find(const std::string& sessionId) const
{
    if (const auto known = m_known.find(sessionId); known != m_known.end())
        return known->second;
    if (m_folder.empty())
        return std::nullopt;
    const auto text = readWholeFile(fileOf(sessionId), kCredentialLimit);
    if (!text)
        return std::nullopt;
    // "participant key"
    Token token{};
    const char* end = text->data() + text->size();
    const auto [rest, error] = std::from_chars(text->data(), end, token.participant.value);
    if (error != std::errc{} || rest == end || *rest != ' ')
        return std::nullopt;
    const auto key = keyFromHex(std::string{rest + 1, end});
    if (!key)
        return std::nullopt;
    token.key = *key;
    return token;
}

Result<void> TokenFolder::keep(const std::string& sessionId, const Token& token)
{
    m_known.insert_or_assign(sessionId, token);
    if (m_folder.empty())
        return {};
    makePrivate();
    return writePrivateFile(fileOf(sessionId),
                            std::to_string(token.participant.value) + ' ' + toHex(token.key));
}

bool TokenFolder::hasAny() const
{
    if (!m_known.empty())
        return true;
    std::error_code none;
    const std::filesystem::directory_iterator files{m_folder, none};
    return std::any_of(begin(files), end(files),
                       [ending = whose() + kTokenEnding](const auto& file) {
                           return file.path().filename().string().ends_with(ending);
                       });
}

std::optional<TokenFolder::Visit> TokenFolder::lastVisit() const
{
    if (m_folder.empty())
        return std::nullopt;
    const auto text = readWholeFile(fileOfVisit(), kCredentialLimit);
    if (!text)
        return std::nullopt;
    // "session address port"
    const std::size_t address = text->find(' ') + 1;
    const std::size_t port = text->rfind(' ') + 1;
    if (address == 0 || port <= address)
        return std::nullopt;
    Visit visit{text->substr(0, address - 1), text->substr(address, port - address - 1)};
    const char* end = text->data() + text->size();
    const auto [rest, error] = std::from_chars(text->data() + port, end, visit.port);
    const bool isRight = error == std::errc{} && rest == end && isSessionId(visit.sessionId);
    return isRight && find(visit.sessionId) ? std::optional{visit} : std::nullopt;
}

Result<void> TokenFolder::keepVisit(const Visit& visit) const
{
    if (m_folder.empty())
        return {};
    makePrivate();
    return writePrivateFile(fileOfVisit(), visit.sessionId + ' ' + visit.address + ' '
                                               + std::to_string(visit.port));
}

/// The names of the files tell whose they are to who guesses the name. Where this fails, writing
/// does too, or the folder is not the user's own.
void TokenFolder::makePrivate() const
{
    std::error_code error;
    std::filesystem::create_directories(m_folder, error);
    std::filesystem::permissions(m_folder, std::filesystem::perms::owner_all, error);
}

std::string TokenFolder::whose() const
{
    // Names may hold anything; their hash may not.
    const QByteArray name =
        QCryptographicHash::hash(QByteArray::fromStdString(m_name), QCryptographicHash::Sha256)
            .toHex()
            .first(16);
    return '-' + std::string{roleWord(m_role)} + '-' + name.toStdString();
}

std::filesystem::path TokenFolder::fileOf(const std::string& sessionId) const
{
    return m_folder / (sessionId + whose() + kTokenEnding);
}

std::filesystem::path TokenFolder::fileOfVisit() const
{
    return m_folder / ("last" + whose() + ".visit");
}

} // namespace carina
