#include "apps/lab/attack/attackers/impostors.h"

#include "apps/lab/attack/attackers/attendee.h"
#include "engine/session/facts/fact_codec.h"

#include <limits>

namespace carina::lab
{
namespace
{

/// Wants to come in as a trainee who is present, by the id with which that one came in.
class Impostor : public Attack
{
public:
    explicit Impostor(const Target& target)
        : m_name{target.attacker},
          m_victim{target.victim},
          m_random{randomOf(target.attacker)},
          m_watcher{wayIn(target, Role::Observer)},
          m_impostor{wayIn(target, Role::Trainee)}
    {
    }

    void step() override
    {
        if (!m_watcher.isIn() || !m_impostor.isIn())
            return;
        if (!m_watcher.welcome() && m_connection % kTurns == 1)
            m_watcher.hello(m_name, ProposalId{m_random()}, m_connection);
        m_watcher.acknowledge();
        for (const FactRecord& record : m_watcher.facts()) {
            const auto fact = fromRecord(record);
            const auto* joined = fact ? std::get_if<fact::ParticipantJoined>(&fact->body) : nullptr;
            if (joined != nullptr && joined->name == m_victim)
                m_join = record.proposal;
        }
        ++m_connection;
        if (m_join)
            m_impostor.hello(m_victim, *m_join, m_connection);
    }
    [[nodiscard]] std::int64_t sent() const override { return m_impostor.sent(); }
    [[nodiscard]] bool isTakenForAnother() const override
    {
        return m_impostor.welcome().has_value();
    }

private:
    static constexpr std::uint32_t kTurns = 100;
    std::string m_name;
    std::string m_victim;
    std::mt19937_64 m_random;
    Intruder m_watcher;
    Intruder m_impostor;
    std::optional<ProposalId> m_join;
    std::uint32_t m_connection = 1;
};

/// What somebody in the session learns of a trainee who is present: all but its token.
struct Known {
    std::string sessionId;
    std::optional<ParticipantId> participant;
};

Known knownOf(const std::string& name, const std::vector<FactRecord>& facts)
{
    Known known;
    for (const FactRecord& record : facts) {
        const auto fact = fromRecord(record);
        if (!fact)
            continue;
        if (const auto* created = std::get_if<fact::SessionCreated>(&fact->body))
            known.sessionId = created->sessionId;
        const auto* joined = std::get_if<fact::ParticipantJoined>(&fact->body);
        if (joined != nullptr && joined->name == name)
            known.participant = joined->participant;
    }
    return known;
}

/// Says that it is a trainee who is present: by that one's number with a key that is not its token,
/// and by its name with the code of the role.
class FalseToken : public Attack
{
public:
    explicit FalseToken(const Target& target)
        : m_target{target},
          m_random{randomOf(target.attacker)},
          m_watcher{wayIn(target, Role::Observer)},
          m_namesake{wayIn(target, Role::Trainee)}
    {
    }

    void step() override
    {
        if (m_known.participant)
            knock(monotonicNow());
        if (!m_watcher.isIn() || !m_namesake.isIn())
            return;
        if (!m_watcher.welcome() && m_connection % kTurns == 1)
            m_watcher.hello(m_target.attacker, ProposalId{m_random()}, m_connection);
        m_watcher.acknowledge();
        m_namesake.hello(m_target.victim, ProposalId{m_random()}, ++m_connection);
        if (!m_known.participant)
            m_known = knownOf(m_target.victim, m_watcher.facts());
    }
    [[nodiscard]] std::int64_t sent() const override { return m_namesake.sent() + m_refused; }
    [[nodiscard]] bool isTakenForAnother() const override { return m_namesake.welcome() || m_isIn; }
    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        return {{"tokens at random in a second that the host refused",
                 double(m_refused) / toSeconds(length), 1.0,
                 std::numeric_limits<double>::infinity()}};
    }

private:
    static constexpr std::uint32_t kTurns = 100;
    /// As often as leaves others of its address their share of the handshakes.
    static constexpr Duration kKnock = std::chrono::milliseconds{30};
    /// A busy host answers late; it says nothing where its share of handshakes is used up.
    static constexpr Duration kPatience = std::chrono::milliseconds{250};

    /// A path over which the host is offered a token at random, and no code.
    struct Door {
        ClientCredentials credentials;
        std::optional<ExpectedCertificate> nothing{};
        ClientPath path;

        Door(const Target& target, TokenFolder tokens, LocalTime now)
            : credentials{Role::Trainee, std::nullopt, std::move(tokens), target.derive},
              path{QHostAddress{QHostAddress::LocalHost},
                   target.port,
                   credentials,
                   nothing,
                   [] {},
                   now}
        {
        }
    };

    void knock(LocalTime now)
    {
        if (m_door && isUndecided(now))
            return;
        m_door = nullptr;
        if (now < m_nextKnock)
            return;
        m_nextKnock = now + kKnock;
        TokenFolder tokens{{}, Role::Trainee, m_target.victim};
        static_cast<void>( // in memory, which does not fail
            tokens.keep(m_known.sessionId, {*m_known.participant, randomKey()}));
        m_door = std::make_unique<Door>(m_target, std::move(tokens), now);
    }

    /// Whether the host may still answer; counts what it has answered.
    bool isUndecided(LocalTime now)
    {
        ClientPath& path = m_door->path;
        path.serve([](std::span<const std::byte>, LocalTime) {});
        m_isIn = m_isIn || path.state() == ClientPath::State::Encrypted;
        m_refused += path.offer() && path.state() == ClientPath::State::Failed ? 1 : 0;
        return path.state() == ClientPath::State::Opening && now < path.opened() + kPatience;
    }

    Target m_target;
    std::mt19937_64 m_random;
    Intruder m_watcher;
    Intruder m_namesake;
    Known m_known;
    std::uint32_t m_connection = 1;
    std::unique_ptr<Door> m_door;
    LocalTime m_nextKnock{};
    std::int64_t m_refused = 0; ///< tokens
    bool m_isIn = false;
};

} // namespace

std::unique_ptr<Attack> beginImpostor(const Target& target)
{
    return std::make_unique<Impostor>(target);
}

std::unique_ptr<Attack> beginFalseToken(const Target& target)
{
    return std::make_unique<FalseToken>(target);
}

} // namespace carina::lab
