#pragma once

#include "engine/net/entry/access_key.h"
#include "engine/net/entry/psk_identity.h"

#include <filesystem>
#include <map>

namespace carina
{

/// The tokens issued to a program, with which it joins a session again without its code: one file
/// for each session, role and name, which only its owner may read, in a folder that only its owner
/// may open; and beside them which session a role and name were in last.
class TokenFolder
{
public:
    struct Token {
        ParticipantId participant;
        AccessKey key;
    };

    /// A session that was come into, and the place that a person or a link had given for its host.
    struct Visit {
        std::string sessionId;
        std::string address;
        std::uint16_t port = 0;

        friend bool operator==(const Visit&, const Visit&) = default;
    };

    /// @param folder empty: tokens are kept in memory only
    TokenFolder(std::filesystem::path folder, Role role, std::string name);

    /// Nothing where no token is stored, or it cannot be read.
    [[nodiscard]] std::optional<Token> find(const std::string& sessionId) const;
    /// Whether a token of any session is stored for this role and name.
    [[nodiscard]] bool hasAny() const;
    /// Stores a token. @returns FileUnwritable; the token is then kept in memory.
    Result<void> keep(const std::string& sessionId, const Token& token);
    /// The latest visit of this role and name, of which there is a token; nothing where none was
    /// kept, or it cannot be read.
    [[nodiscard]] std::optional<Visit> lastVisit() const;
    /// Stores a visit in place of the one before; not without a folder. @returns FileUnwritable
    Result<void> keepVisit(const Visit& visit) const;

private:
    void makePrivate() const;
    /// In the names of the files: whose they are.
    [[nodiscard]] std::string whose() const;
    [[nodiscard]] std::filesystem::path fileOf(const std::string& sessionId) const;
    [[nodiscard]] std::filesystem::path fileOfVisit() const;

    std::filesystem::path m_folder;
    Role m_role;
    std::string m_name;
    std::map<std::string, Token> m_known; // by session
};

} // namespace carina
