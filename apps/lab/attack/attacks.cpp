#include "apps/lab/attack/attacks.h"

#include "apps/lab/attack/false_tube.h"
#include "apps/lab/attack/foreign_actions.h"
#include "apps/lab/attack/gallery.h"
#include "apps/lab/attack/impostors.h"
#include "apps/lab/attack/overloads.h"
#include "apps/lab/attack/participating.h"
#include "apps/lab/attack/returning.h"
#include "apps/lab/attack/steady.h"
#include "engine/anatomy/patient/patient_name.h"
#include "engine/session/facts/fact_codec.h"

#include <QSslPreSharedKeyAuthenticator>

#include <algorithm>
#include <array>
#include <iterator>
#include <ranges>
#include <utility>

namespace carina::lab
{
namespace
{

/// Proposes as much as fits into some datagrams.
class Proposing : public Participating
{
public:
    using Participating::Participating;

protected:
    void flood(Intruder& intruder) override
    {
        std::vector<WireRecord> proposals;
        for (int i = 0; i < kProposals; ++i)
            proposals.emplace_back(
                toRecord(Proposal{anyId(), kNobody, intruder.station(), body(intruder)}));
        intruder.send(proposals);
    }

private:
    static constexpr int kProposals = 100;

    /// @pre it was welcomed
    [[nodiscard]] virtual FactBody body(const Intruder& intruder) = 0;
};

class Leaving : public Proposing
{
public:
    explicit Leaving(const Target& target) : Proposing{target, Role::Observer} {}

private:
    FactBody body(const Intruder& intruder) override
    {
        return fact::ParticipantLeft{intruder.welcome()->participant};
    }
};

/// Shares ever more tubes, and hands them over to the host in turn, to make room for the next.
class Sharing : public Proposing
{
public:
    explicit Sharing(const Target& target) : Proposing{target, Role::Trainee} {}

private:
    static constexpr ParticipantId kHost{0};

    FactBody body(const Intruder& intruder) override
    {
        const ParticipantId self = intruder.welcome()->participant;
        if (anyNumber() % 2 == 0)
            if (const auto shared = newestOf(intruder, self))
                return fact::ObjectHandedOver{*shared, kHost, 1};
        return fact::ObjectShared{ObjectId{}, self, ObjectKind::Tube, std::to_string(anyNumber())};
    }
    static std::optional<ObjectId> newestOf(const Intruder& intruder, ParticipantId self)
    {
        for (const FactRecord& record : intruder.facts() | std::views::reverse) {
            const auto fact = fromRecord(record);
            const auto* shared = fact ? std::get_if<fact::ObjectShared>(&fact->body) : nullptr;
            if (shared && shared->owner == self)
                return shared->object;
        }
        return std::nullopt;
    }
};

class Breathing : public Proposing
{
public:
    explicit Breathing(const Target& target) : Proposing{target, Role::Trainee} {}

private:
    FactBody body(const Intruder& intruder) override
    {
        return fact::ManikinBreathed{intruder.sessionNow()};
    }
};

/// Chooses the place where it is, and states the registration that it has, without end.
class Repeating : public Proposing
{
public:
    explicit Repeating(const Target& target) : Proposing{target, Role::Trainee} {}

private:
    FactBody body(const Intruder& intruder) override
    {
        if (anyNumber() % 2 == 0)
            return fact::RegistrationStated{{RegistrationState::Good, {}, millimetres(1.0)}};
        return fact::PlaceChosen{intruder.welcome()->participant, {}};
    }
};

/// Decides without end what an instructor may decide about the patient, a tenth more often than
/// the host takes: who floods it is soon put out.
class Instructing : public Participating
{
public:
    explicit Instructing(const Target& target) : Participating{target, Role::Instructor} {}

    [[nodiscard]] std::int64_t patientsLaid() const override
    {
        if (!intruder().welcome())
            return 0;
        const ParticipantId self = intruder().welcome()->participant;
        return std::ranges::count_if(intruder().facts(), [self](const FactRecord& record) {
            const auto fact = fromRecord(record);
            return record.author == self && fact
                   && std::holds_alternative<fact::AnatomyChosen>(fact->body);
        });
    }

protected:
    void flood(Intruder& intruder) override
    {
        const LocalTime now = monotonicNow();
        m_next = std::max(m_next, now - kMostBehind);
        std::vector<WireRecord> proposals;
        for (; m_next < now; m_next += kInterval)
            proposals.emplace_back(
                toRecord(Proposal{anyId(), kNobody, intruder.station(), body()}));
        if (!proposals.empty())
            intruder.send(proposals);
    }

private:
    static constexpr Duration kInterval = std::chrono::microseconds{9091}; ///< 110 a second
    static constexpr Duration kMostBehind = std::chrono::milliseconds{100};

    FactBody body()
    {
        const double share = 0.01 * double(anyNumber() % 100);
        switch (anyNumber() % 4) {
        case 0:
            return chosen(anyNumber() % 2 == 0 ? BuiltinPatient::Adult
                                               : BuiltinPatient::TwelveYears);
        case 1:
            return fact::BreathingRateSet{perMinute(10.0 + 30.0 * share)};
        case 2:
            return fact::LungConditionsSet{{{ConditionKind::Asthma, share, ConditionSide::Both}}};
        default:
            return fact::TidalVolumeSet{millilitres(200.0 + 300.0 * share)};
        }
    }
    static FactBody chosen(BuiltinPatient patient)
    {
        const PatientParameters parameters = parametersOf(patient);
        return fact::AnatomyChosen{madeHash(parameters), nameOf(parameters)};
    }

    LocalTime m_next{};
};

/// Gives observers a new code without end.
class NewCodes : public Proposing
{
public:
    explicit NewCodes(const Target& target) : Proposing{target, Role::Instructor} {}

private:
    FactBody body(const Intruder&) override { return fact::RoleCodeChanged{Role::Observer}; }
};

/// Sends what is no datagram.
class Garbage : public Participating
{
public:
    explicit Garbage(const Target& target) : Participating{target, Role::Observer} {}

protected:
    void flood(Intruder& intruder) override
    {
        for (int i = 0; i < kDatagrams; ++i) {
            std::array<std::byte, 800> bytes{};
            for (std::byte& byte : bytes)
                byte = std::byte(anyNumber());
            intruder.sendBytes(bytes);
        }
    }

private:
    static constexpr int kDatagrams = 10;
};

/// Comes in over one path under ever new names.
class Names : public Attack
{
public:
    explicit Names(const Target& target)
        : m_name{target.attacker}, m_intruder{wayIn(target, Role::Trainee)}
    {
    }

    void step() override
    {
        if (!m_intruder.isIn())
            return;
        for (int i = 0; i < kHellos; ++i) {
            ++m_names;
            m_intruder.hello(m_name + std::to_string(m_names), ProposalId{m_names}, m_names);
        }
    }
    [[nodiscard]] std::int64_t sent() const override { return m_intruder.sent(); }

private:
    static constexpr int kHellos = 5;
    std::string m_name;
    Intruder m_intruder;
    std::uint32_t m_names = 0;
};

/// Opens paths over which nobody comes in.
class IdlePaths : public Attack
{
public:
    explicit IdlePaths(const Target& target)
        : m_target{target},
          m_credentials{Role::Observer, target.codes.at(Role::Observer),
                        TokenFolder{{}, Role::Observer, "Intruder"}, target.derive}
    {
    }

    void step() override
    {
        const LocalTime now = monotonicNow();
        std::int64_t open = 0;
        for (Idle& idle : m_paths) {
            idle.path->serve([](std::span<const std::byte>, LocalTime) {});
            if (idle.path->state() != ClientPath::State::Encrypted)
                continue;
            ++open;
            m_opened += std::exchange(idle.wasOpen, true) ? 0 : 1;
        }
        m_mostOpen = std::max(m_mostOpen, open);
        if (now < m_next)
            return;
        m_next = now + std::chrono::milliseconds{15};
        if (m_paths.size() == kPaths)
            m_paths.erase(m_paths.begin());
        m_paths.push_back({std::make_unique<ClientPath>(
            QHostAddress{QHostAddress::LocalHost}, m_target.port, m_credentials, m_nothing, [] {},
            now)});
    }
    [[nodiscard]] std::int64_t sent() const override { return m_opened; }
    [[nodiscard]] std::int64_t mostPaths() const override { return m_mostOpen; }

private:
    static constexpr std::size_t kPaths = 400;

    struct Idle {
        std::unique_ptr<ClientPath> path;
        bool wasOpen = false;
    };

    Target m_target;
    ClientCredentials m_credentials;
    std::optional<ExpectedCertificate> m_nothing;
    std::vector<Idle> m_paths;
    LocalTime m_next{};
    std::int64_t m_opened = 0; ///< that came to be encrypted
    std::int64_t m_mostOpen = 0;
};

/// Sends ClientHellos without a cookie, from one address.
class ClientHellos : public Attack
{
public:
    explicit ClientHellos(const Target& target) : m_port{target.port}
    {
        // The first datagram of a handshake, sent to a socket of our own.
        QUdpSocket ear;
        ear.bind(QHostAddress::LocalHost);
        m_socket.bind(QHostAddress::LocalHost);
        QDtls dtls{QSslSocket::SslClientMode};
        dtls.setPeer(QHostAddress{QHostAddress::LocalHost}, ear.localPort());
        prepareDtls(dtls, QByteArray{});
        dtls.doHandshake(&m_socket);
        if (ear.waitForReadyRead(1000))
            if (const auto datagram = readRaw(ear))
                m_hello = datagram->bytes;
    }

    void step() override
    {
        const QHostAddress host{QHostAddress::LocalHost};
        for (int i = 0; i < kHellos && !m_hello.isEmpty(); ++i)
            m_sent += m_socket.writeDatagram(m_hello, host, m_port) == m_hello.size() ? 1 : 0;
        while (readRaw(m_socket)) {}
    }
    [[nodiscard]] std::int64_t sent() const override { return m_sent; }

private:
    static constexpr int kHellos = 5;
    std::uint16_t m_port;
    QUdpSocket m_socket;
    QByteArray m_hello;
    std::int64_t m_sent = 0;
};

/// All kinds that can act at the same time, each by an attacker of its own.
class Together : public Attack
{
public:
    explicit Together(const Target& target)
    {
        int number = 0;
        for (const AttackKind& single : attackKinds()) {
            if (!actsBesideOthers(single))
                continue;
            Target own = target;
            own.attacker += ' ' + std::to_string(number++);
            m_attacks.push_back(single.begin(own));
            m_keepsOut.push_back(single.keepsOut);
        }
    }

    void step() override
    {
        const bool allBegin = monotonicNow() >= m_allFrom;
        for (std::size_t i = 0; i < m_attacks.size(); ++i)
            if (allBegin || !m_keepsOut[i])
                m_attacks[i]->step();
    }
    [[nodiscard]] std::int64_t sent() const override
    {
        std::int64_t sum = 0;
        for (const auto& attack : m_attacks)
            sum += attack->sent();
        return sum;
    }
    [[nodiscard]] bool isTakenForAnother() const override
    {
        return std::ranges::any_of(m_attacks,
                                   [](const auto& attack) { return attack->isTakenForAnother(); });
    }
    [[nodiscard]] std::int64_t patientsLaid() const override
    {
        std::int64_t sum = 0;
        for (const auto& attack : m_attacks)
            sum += attack->patientsLaid();
        return sum;
    }
    [[nodiscard]] std::int64_t mostPaths() const override
    {
        std::int64_t sum = 0;
        for (const auto& attack : m_attacks)
            sum += attack->mostPaths();
        return sum;
    }
    [[nodiscard]] std::vector<Measured> measured(Duration length) const override
    {
        const auto acted = std::ranges::count_if(
            m_attacks, [](const auto& attack) { return attack->sent() >= kLeastOfEach; });
        std::vector<Measured> all{{"attackers that sent or opened at least ten",
                                   static_cast<double>(acted), double(kAttackersAtOnce),
                                   double(kAttackersAtOnce)}};
        for (const auto& attack : m_attacks)
            std::ranges::copy(attack->measured(length), std::back_inserter(all));
        return all;
    }

private:
    /// In which the others come in, who would have to wait behind the handshakes and names of
    /// these, or find the places of their address taken by them.
    static constexpr Duration kHeadStart = std::chrono::milliseconds{1500};
    static constexpr std::int64_t kLeastOfEach = 10;

    std::vector<std::unique_ptr<Attack>> m_attacks;
    std::vector<bool> m_keepsOut; // of each
    LocalTime m_allFrom = monotonicNow() + kHeadStart;
};

template <class Kind> std::unique_ptr<Attack> begin(const Target& target)
{
    return std::make_unique<Kind>(target);
}

} // namespace

WayIn wayIn(const Target& target, Role role)
{
    return {target.port, role, target.codes.at(role), target.derive};
}

bool actsBesideOthers(const AttackKind& kind)
{
    return !kind.isAllOthers && !kind.spoils && !kind.needsRoom
           && kind.strategy == StrategyKind::SessionClock;
}

std::span<const AttackKind> attackKinds()
{
    // One for each coming and going of those who take part: attacker, newcomers, listener.
    constexpr double kComings = 20.0;
    // As many as the host takes from an instructor in a second, and a tenth.
    constexpr double kInstructing = 110.0;
    // Of these, since what is chosen already becomes no fact.
    constexpr double kLeastInstructing = 80.0;
    // Twelve comings and goings, what each may have saved up, and a burst of the pot; then by the
    // second the shares and the pot of trainees of one address, and a tenth (sharedLimitsOf).
    constexpr double kCrowd = 12.0 * (2.0 + 8.0) + 2.0 * 40.0;
    constexpr double kCrowdPerS = 88.0;
    // More than one name has by itself.
    constexpr double kLeastOfMany = 30.0;
    // The names of the turns come in once each, and have saved up as much as those of a crowd.
    constexpr double kTurns = 24.0 * 2.0 + 24.0 * 8.0 + 2.0 * 40.0;
    // Breaths of a manikin in a second, see kShortestBreath.
    constexpr double kBreathing = 1.2;
    // Two tubes, and what they are handed over.
    constexpr double kSharing = 4.0;
    // Whoever floods the host is put out after several seconds, and comes in again: two facts.
    constexpr double kComingAgain = 0.4;
    // The names of one who sends of every kind.
    constexpr double kSteady = 3.0 * 8.0;
    // What one trainee may propose: a burst, and by the second, and a tenth.
    constexpr double kOwn = 44.0;
    constexpr double kOwnPerS = 22.0;
    // Idle ones that the host keeps for a code.
    constexpr double kIdlePaths = 64.0;
    // So many that of one block of memory, 32 bytes at least, for each of them more would be left
    // than a console's memory varies by.
    constexpr double kMany = 250'000.0;
    static constexpr std::array kKinds{
        AttackKind{.name = "leaving",
                   .what = "an observer proposes that it leaves, without end",
                   .begin = begin<Leaving>,
                   .mostFacts = kComings},
        AttackKind{.name = "sharing",
                   .what = "a trainee shares ever more tubes, and hands them over to the host",
                   .begin = begin<Sharing>,
                   .mostFacts = kComings + kSharing},
        AttackKind{.name = "breathing",
                   .what = "a trainee proposes breaths of the manikin without end",
                   .begin = begin<Breathing>,
                   .mostFacts = kComings,
                   .factsPerS = kBreathing},
        AttackKind{.name = "repeating",
                   .what = "a trainee proposes the place and the registration that it has",
                   .begin = begin<Repeating>,
                   .mostFacts = kComings + 1.0},
        AttackKind{.name = "impostor",
                   .what = "a trainee says Hello with the join of one who is present",
                   .begin = beginImpostor,
                   .mostFacts = kComings},
        AttackKind{.name = "false-token",
                   .what = "one says that it is a trainee who is present, whose name and number it "
                           "knows, without the token",
                   .begin = beginFalseToken,
                   .mostFacts = kComings},
        AttackKind{.name = "client-hellos",
                   .what = "ClientHellos without a cookie",
                   .begin = begin<ClientHellos>,
                   .mostFacts = kComings},
        AttackKind{.name = "paths",
                   .what = "an observer opens paths and says no Hello",
                   .begin = begin<IdlePaths>,
                   .mostFacts = kComings,
                   .mostPaths = kIdlePaths,
                   .keepsOut = true},
        AttackKind{.name = "false-tube",
                   .what = "a trainee streams a second tube, in time and 200 ms ahead of the "
                           "session, as its own and in the place of what others have",
                   .begin = beginFalseTube,
                   .mostFacts = kComings},
        AttackKind{.name = "shown",
                   .what = "a trainee tells without end where its tube was shown",
                   .begin = beginShowing,
                   .mostFacts = kComings + 1.0},
        AttackKind{.name = "crowd",
                   .what = "a trainee asks for tubes under twelve names, each within its budget",
                   .begin = beginCrowd,
                   .mostFacts = kComings + kCrowd,
                   .factsPerS = kCrowdPerS,
                   .leastPerS = kLeastOfMany,
                   .keepsOut = true},
        AttackKind{.name = "strangers",
                   .what =
                       "datagrams over paths with an observer's code over which nobody comes in",
                   .begin = beginStrangers,
                   .mostFacts = kComings,
                   .mostPaths = kIdlePaths},
        AttackKind{.name = "actions",
                   .what = "a trainee acts on what is not its own, as its owner would",
                   .begin = beginForeignActions,
                   .mostFacts = kComings + 1.0},
        AttackKind{.name = "names",
                   .what = "a trainee comes in under ever new names over one path",
                   .begin = begin<Names>,
                   .mostFacts = kComings,
                   .keepsOut = true},
        AttackKind{.name = "garbage",
                   .what = "an observer sends bytes at random",
                   .begin = begin<Garbage>,
                   .mostFacts = kComings,
                   .factsPerS = kComingAgain,
                   .leastSent = kMany},
        AttackKind{.name = "instructing",
                   .what = "an instructor changes the patient and its breathing without end",
                   .begin = begin<Instructing>,
                   .mostFacts = kComings + 2.0 * kInstructing,
                   .factsPerS = kInstructing,
                   .leastPerS = kLeastInstructing},
        AttackKind{.name = "messages",
                   .what = "a trainee acts on what is not its own by messages of the strategy "
                           "\"none\", which the session has meanwhile",
                   .begin = beginForeignMessages,
                   .mostFacts = kComings + 1.0,
                   .strategy = StrategyKind::None},
        AttackKind{.name = "steady",
                   .what = "a trainee sends datagrams of every kind under eight names, as fast as "
                           "each may",
                   .begin = beginSteady,
                   .mostFacts = kComings + kSteady,
                   .leastSent = kMany},
        AttackKind{.name = "turns",
                   .what = "a trainee proposes under 24 names, of which four are there at a time, "
                           "as much as each may",
                   .begin = beginTurns,
                   .mostFacts = kComings + kTurns,
                   .factsPerS = kCrowdPerS,
                   .leastPerS = kLeastOfMany,
                   .keepsOut = true},
        AttackKind{.name = "hungry",
                   .what = "a trainee says without end that it has nothing of the log",
                   .begin = beginHungry,
                   .mostFacts = kComings + kOwn,
                   .factsPerS = kOwnPerS},
        AttackKind{.name = "together",
                   .what = "nineteen attackers at once, in all of these ways but \"messages\", "
                           "\"new-codes\" and \"gallery\", which would hinder the others",
                   .begin = begin<Together>,
                   // All trainees share the budget of one address.
                   .mostFacts = double(kAttackersAtOnce) * kComings + kSharing + 2.0 * kInstructing
                                + kCrowd + kTurns + kSteady + kOwn,
                   .factsPerS = kBreathing + kInstructing + kCrowdPerS,
                   .leastPerS = 2.0 * kLeastOfMany,
                   .mostPaths = kIdlePaths,
                   .isAllOthers = true},
        AttackKind{.name = "new-codes",
                   .what = "an instructor gives observers a new code without end",
                   .begin = begin<NewCodes>,
                   .mostFacts = kComings,
                   .factsPerS = 2.0,
                   .spoils = Role::Observer},
        AttackKind{
            .name = "gallery",
            .what = "a trainee shares four objects under each of 32 names, and streams all: more "
                    "than a station may have",
            .begin = beginGallery,
            .mostFacts = kComings + kGalleryNames * (2.0 + kGalleryObjects),
            .leastPerS = 2.0,
            .needsRoom = true}};
    return kKinds;
}

} // namespace carina::lab
