#include "engine/net/entry/session_secrets.h"

#include "engine/io/files/json_fields.h"
#include "engine/io/files/whole_file.h"

#include <QJsonDocument>

namespace carina
{
namespace
{

const QString kSecretsSchema = QStringLiteral("carina-secrets-1");

QJsonValue jsonText(std::string_view text)
{
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

AccessKey readKey(JsonFields& fields, const char* name)
{
    const auto key = keyFromHex(fields.text(name));
    if (!key)
        fields.refuse(name, "64 hexadecimal digits");
    return key.value_or(AccessKey{});
}

} // namespace

SessionSecrets::SessionSecrets(std::filesystem::path file, std::string sessionId)
    : m_file{std::move(file)}, m_sessionId{std::move(sessionId)}
{
}

Result<SessionSecrets> SessionSecrets::open(std::filesystem::path file, std::string sessionId)
{
    SessionSecrets secrets{std::move(file), std::move(sessionId)};
    std::error_code error;
    if (!secrets.m_file.empty() && std::filesystem::exists(secrets.m_file, error)) {
        if (const auto known = secrets.read(); !known)
            return tl::unexpected(known.error());
        return secrets;
    }
    for (const Role role : {Role::Instructor, Role::Trainee, Role::Observer})
        secrets.m_codes.emplace(role, JoinCode::random());
    if (const auto kept = secrets.write(); !kept)
        return tl::unexpected(kept.error());
    return secrets;
}

std::optional<AccessKey> SessionSecrets::codeKey(Role role) const
{
    const auto known = m_codeKeys.find(role);
    return known == m_codeKeys.end() ? std::nullopt : std::optional{known->second};
}

void SessionSecrets::changeCode(Role role)
{
    m_codes.insert_or_assign(role, JoinCode::random());
    m_codeKeys.erase(role);
}

std::optional<AccessKey> SessionSecrets::token(Role role, ParticipantId participant) const
{
    const auto known = m_tokens.find({role, participant});
    return known == m_tokens.end() ? std::nullopt : std::optional{known->second};
}

AccessKey SessionSecrets::newToken(Role role, ParticipantId participant)
{
    const AccessKey token = randomKey();
    m_tokens.insert_or_assign(std::pair{role, participant}, token);
    return token;
}

void SessionSecrets::moveBeside(std::filesystem::path file)
{
    if (!m_file.empty())
        m_file = file.replace_extension(m_file.extension());
}

void SessionSecrets::revertTo(const SessionSecrets& others)
{
    for (const auto& [role, code] : others.m_codes) {
        if (m_codes.at(role) == code)
            continue;
        m_codes.insert_or_assign(role, code);
        m_codeKeys.erase(role);
        if (const auto key = others.codeKey(role))
            m_codeKeys.emplace(role, *key);
    }
    m_tokens = others.m_tokens;
}

Result<void> SessionSecrets::read()
{
    const auto json = readJsonFile(m_file, kSecretsSchema);
    if (!json)
        return tl::unexpected(json.error());
    std::optional<Error> fault;
    JsonFields fields{*json, fault};
    if (fields.text("session_id") != m_sessionId)
        fields.refuse("session_id", "the session beside it is another");
    for (JsonFields& entry : fields.objects("codes")) {
        const auto role = roleOfWord(entry.text("role"));
        const auto code = JoinCode::parse(entry.text("code"));
        if (!role || !code) {
            entry.refuse("code", "a role and its code");
            continue;
        }
        m_codes.emplace(*role, *code);
        if (entry.has("key"))
            m_codeKeys.emplace(*role, readKey(entry, "key"));
    }
    for (JsonFields& entry : fields.objects("tokens")) {
        const auto whose = pskIdentity(entry.text("participant"));
        if (whose && whose->who.participant)
            m_tokens.emplace(std::pair{whose->who.role, *whose->who.participant},
                             readKey(entry, "token"));
        else
            entry.refuse("participant", "role, session and number");
    }
    if (m_codes.size() != 3)
        fields.refuse("codes", "one for each role");
    if (fault)
        return fail(fault->code, m_file.string() + ": " + fault->detail);
    return {};
}

Result<void> SessionSecrets::write() const
{
    if (m_file.empty())
        return {};
    QJsonArray codes;
    for (const auto& [role, code] : m_codes) {
        QJsonObject entry{{QStringLiteral("role"), jsonText(roleWord(role))},
                          {QStringLiteral("code"), jsonText(code.text())}};
        if (const auto key = codeKey(role))
            entry.insert(QStringLiteral("key"), jsonText(toHex(*key)));
        codes.append(entry);
    }
    QJsonArray tokens;
    for (const auto& [whose, token] : m_tokens) {
        const PskIdentity identity{{whose.first, whose.second}, m_sessionId};
        tokens.append(QJsonObject{{QStringLiteral("participant"), jsonText(toText(identity))},
                                  {QStringLiteral("token"), jsonText(toHex(token))}});
    }
    const QJsonObject all{{QStringLiteral("schema"), kSecretsSchema},
                          {QStringLiteral("session_id"), jsonText(m_sessionId)},
                          {QStringLiteral("codes"), codes},
                          {QStringLiteral("tokens"), tokens}};
    return writePrivateFile(m_file, QJsonDocument{all}.toJson().toStdString());
}

} // namespace carina
