#pragma once

#include "engine/net/node/session_node.h"
#include "engine/sync/wire/datagram.h"
#include "models/session/session_plan.h"

#include <QString>

#include <optional>

namespace carina
{

/// The fields that a person fills in to join a session.
struct JoinForm {
    QString address{};
    QString port{};
    QString code{};
    QString name{};
    Role role = Role::Trainee;
    QString certificate{}; ///< the name in the host's certificate, if it has one
    QString station{};     ///< its name; empty: where this participant was last, else the first
    /// Address and port are those of the last time: a session that is found is more likely meant.
    bool isPlaceOfLastTime = false;
};

enum class JoinField : std::uint8_t { Address, Port, Code, Name, Certificate, Station };

/// What has to be corrected in a form, and in which field.
struct JoinGap {
    JoinField field = JoinField::Address;
    QString sentence{};
};

/// If the address field holds a valid join link, the form with the fields that the link contains;
/// else the form as it is.
[[nodiscard]] JoinForm withLinkRead(JoinForm form);

/// What still has to be corrected; std::nullopt if the form can be used. The code may be missing
/// only if a token of an earlier visit with this name and role was kept.
/// @param tokens the folder that keeps them
[[nodiscard]] std::optional<JoinGap> whatIsMissing(const JoinForm& form,
                                                   const std::filesystem::path& tokens);

/// What has to be corrected after a session refused this form.
[[nodiscard]] JoinGap gapOf(const Error& refusal, const JoinForm& form);

/// Keeps who came in by this form, beside their tokens; where that fails it is typed again next
/// time.
/// @param tokens the folder that keeps them
void keepLastTime(const std::filesystem::path& tokens, const JoinForm& form);
/// The form with what is known of the last time: where it has no name, that name with its role and
/// the host's certificate.
[[nodiscard]] JoinForm withLastPerson(JoinForm form, const std::filesystem::path& tokens);
/// And where it has no address, the one that the person of this form gave last, where they were let
/// in.
[[nodiscard]] JoinForm withLastPlace(JoinForm form, const std::filesystem::path& tokens);
/// The session that the person of this form was in last, and may come into again without a code.
[[nodiscard]] std::optional<SessionKey> lastSession(const JoinForm& form,
                                                    const std::filesystem::path& tokens);

/// A form filled in from settings.
[[nodiscard]] JoinForm formOf(const JoinSettings& settings);

/// Copies the form into the settings. @pre nothing but a code is missing.
void fillIn(JoinSettings& settings, const JoinForm& form);

/// The join link for a guest in this role to a session hosted here: with the first address of this
/// computer, or with its loopback address if the session is not open to other computers.
[[nodiscard]] QString joinLinkText(const SessionNode& host, Role role);

/// A text with the name that guests must find in the host's certificate; empty if it has none.
[[nodiscard]] QString certificateText(const SessionNode& host);

/// A text, after its state mark, on who can reach a session hosted here, and how they find it.
[[nodiscard]] QString reachText(const SessionNode& host, SessionReach reach);

} // namespace carina
