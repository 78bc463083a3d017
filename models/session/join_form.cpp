#include "models/session/join_form.h"

#include "engine/core/expects.h"
#include "engine/io/files/whole_file.h"
#include "engine/net/discovery/addresses.h"
#include "engine/net/entry/join_link.h"
#include "engine/net/entry/session_identity.h"
#include "engine/net/entry/token_folder.h"
#include "engine/session/facts/fact_rules.h"
#include "models/errors/error_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace carina
{
namespace
{

constexpr FileLimit kLastTimeLimit{"the last time", 1024};
constexpr const char* kLastTime = "last-time";

class JoinWords
{
    Q_DECLARE_TR_FUNCTIONS(carina::JoinForm)
};

QString noCode()
{
    return JoinWords::tr("Type the code of your role, which the instructor's window shows.");
}

TokenFolder tokensOf(const JoinForm& form, const std::filesystem::path& tokens)
{
    return {tokens, form.role, form.name.trimmed().toStdString()};
}

bool wasHereBefore(const JoinForm& form, const std::filesystem::path& tokens)
{
    return tokensOf(form, tokens).hasAny();
}

QString wordOfRole(Role role)
{
    const std::string_view word = roleWord(role);
    return QString::fromLatin1(word.data(), qsizetype(word.size()));
}

JoinField fieldOf(Errc refusal)
{
    switch (refusal) {
    case Errc::WrongCode:
    case Errc::NotEnoughMemory:
        return JoinField::Code;
    case Errc::NameTaken:
    case Errc::NameUnclear:
        return JoinField::Name;
    case Errc::StationUnknown:
        return JoinField::Station;
    case Errc::CertificateExpired:
    case Errc::CertificateUntrusted:
    case Errc::CertificateOfAnother:
    case Errc::CertificateMissing:
    case Errc::CertificateNeeded:
        return JoinField::Certificate;
    default:
        return JoinField::Address;
    }
}

} // namespace

JoinForm withLinkRead(JoinForm form)
{
    const auto link = joinLink(form.address.toStdString());
    if (!link)
        return form;
    form.address = QString::fromStdString(link->address);
    form.port = QString::number(link->port);
    form.code = QString::fromStdString(link->code.text());
    form.role = link->role;
    if (!link->certificate.empty())
        form.certificate = QString::fromStdString(link->certificate);
    return form;
}

std::optional<JoinGap> whatIsMissing(const JoinForm& form, const std::filesystem::path& tokens)
{
    using enum JoinField;
    if (const std::string address = form.address.toStdString(); isMeantAsLink(address))
        if (const auto link = joinLink(address); !link)
            return JoinGap{Address, errorText(link.error())};
    const QByteArray name = form.name.trimmed().toUtf8();
    if (name.isEmpty())
        return JoinGap{Name, JoinWords::tr("Type your name, so that the instructor knows you.")};
    if (static_cast<std::size_t>(name.size()) > kLongestText)
        return JoinGap{Name, JoinWords::tr("Type a shorter name.")};
    if (!isAddress(form.address.trimmed().toStdString()))
        return JoinGap{Address,
                       JoinWords::tr("Choose a session, or type the address that the instructor's "
                                     "window shows, such as 192.168.1.20.")};
    bool isNumber = false;
    if (form.port.trimmed().toUShort(&isNumber) == 0 || !isNumber)
        return JoinGap{Port, JoinWords::tr("Type the port that the instructor's window shows: a "
                                           "number from 1 to 65535.")};
    if (form.code.trimmed().isEmpty() && !wasHereBefore(form, tokens))
        return JoinGap{Code, noCode()};
    if (!form.code.trimmed().isEmpty() && !JoinCode::parse(form.code.toStdString()))
        return JoinGap{Code, JoinWords::tr("A code has ten letters and digits, such as "
                                           "7K3QM-XW2PD: compare it with the instructor's "
                                           "window.")};
    if (const QString host = form.certificate.trimmed();
        !host.isEmpty() && !isHostName(host.toStdString()))
        return JoinGap{Certificate,
                       JoinWords::tr("Leave the name in the certificate empty, or type it as the "
                                     "instructor's window shows it, such as "
                                     "carina.hospital.example.")};
    if (static_cast<std::size_t>(form.station.trimmed().toUtf8().size()) > kLongestText)
        return JoinGap{Station, JoinWords::tr("Type a shorter name of a station, or none.")};
    return std::nullopt;
}

JoinGap gapOf(const Error& refusal, const JoinForm& form)
{
    if (refusal.code == Errc::WrongCode && form.code.trimmed().isEmpty())
        return {JoinField::Code, noCode()};
    return {fieldOf(refusal.code), errorText(refusal)};
}

void keepLastTime(const std::filesystem::path& tokens, const JoinForm& form)
{
    const QStringList lines{form.name.simplified(), wordOfRole(form.role),
                            form.certificate.simplified()};
    static_cast<void>(
        writePrivateFile(tokens / kLastTime, lines.join(QLatin1Char{'\n'}).toStdString()));
}

JoinForm withLastPerson(JoinForm form, const std::filesystem::path& tokens)
{
    const auto kept = readWholeFile(tokens / kLastTime, kLastTimeLimit);
    if (!kept || !form.name.isEmpty())
        return form;
    const QStringList lines = QString::fromStdString(*kept).split(QLatin1Char{'\n'});
    form.name = lines.value(0).simplified();
    // An instructor's code is for the console.
    if (lines.value(1) == wordOfRole(Role::Observer))
        form.role = Role::Observer;
    if (form.certificate.isEmpty())
        form.certificate = lines.value(2).simplified();
    return form;
}

JoinForm withLastPlace(JoinForm form, const std::filesystem::path& tokens)
{
    if (!form.address.isEmpty())
        return form;
    if (const auto last = tokensOf(form, tokens).lastVisit()) {
        form.address = QString::fromStdString(last->address);
        form.port = QString::number(last->port);
        form.isPlaceOfLastTime = true;
    }
    return form;
}

std::optional<SessionKey> lastSession(const JoinForm& form, const std::filesystem::path& tokens)
{
    const auto last = tokensOf(form, tokens).lastVisit();
    return last ? std::optional{sessionKey(last->sessionId)} : std::nullopt;
}

JoinForm formOf(const JoinSettings& settings)
{
    return {.address = QString::fromStdString(settings.address),
            .port = settings.port == 0 ? QString{} : QString::number(settings.port),
            .code = settings.code ? QString::fromStdString(settings.code->text()) : QString{},
            .name = QString::fromStdString(settings.participantName),
            .role = settings.role,
            .certificate = settings.certificate ? QString::fromStdString(settings.certificate->name)
                                                : QString{},
            .station = QString::fromStdString(settings.station)};
}

void fillIn(JoinSettings& settings, const JoinForm& form)
{
    const auto missing = whatIsMissing(form, {});
    CARINA_EXPECTS(!missing || missing->field == JoinField::Code);
    settings.participantName = form.name.trimmed().toStdString();
    settings.address = form.address.trimmed().toStdString();
    settings.port = form.port.trimmed().toUShort();
    settings.role = form.role;
    settings.station = form.station.trimmed().toStdString();
    settings.code.reset();
    if (const auto code = JoinCode::parse(form.code.toStdString()))
        settings.code = *code;
    const std::string certificate = form.certificate.trimmed().toStdString();
    if (!certificate.empty() && !settings.certificate)
        settings.certificate.emplace();
    if (settings.certificate) // never given up for an empty field
        settings.certificate->name = certificate;
}

QString joinLinkText(const SessionNode& host, Role role)
{
    const auto addresses = host.isOpen() ? ownAddresses() : std::vector<std::string>{};
    return QString::fromStdString(
        toText(JoinLink{addresses.empty() ? "127.0.0.1" : addresses[0], host.port(), role,
                        host.joinCodes().at(role), host.certificateName()}));
}

QString certificateText(const SessionNode& host)
{
    const QString name = QString::fromStdString(host.certificateName());
    return name.isEmpty() ? QString{} : JoinWords::tr("Its certificate is for %1.").arg(name);
}

QString reachText(const SessionNode& host, SessionReach reach)
{
    QStringList addresses;
    for (const std::string& address : ownAddresses())
        addresses.push_back(QString::fromStdString(address));
    const QString own = addresses.isEmpty() ? JoinWords::tr("an address of this computer")
                                            : addresses.join(JoinWords::tr(" or "));
    const QString port = QString::number(host.port());
    switch (reach) {
    case SessionReach::ThisComputer:
        return JoinWords::tr("○ Only programs on this computer can join. They find the session "
                             "automatically, or at 127.0.0.1 port %1.")
            .arg(port);
    case SessionReach::Network:
        return JoinWords::tr("● Open to the network. Other computers find the session "
                             "automatically, or at %1 port %2.")
            .arg(own, port);
    case SessionReach::ByLink:
        return JoinWords::tr("◆ By link only. Nobody finds the session by searching: give them its "
                             "link, or the address %1, the port %2 and the code.")
            .arg(own, port);
    }
    return {};
}

} // namespace carina
