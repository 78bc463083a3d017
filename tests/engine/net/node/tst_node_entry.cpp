#include "engine/net/node/client_driver.h"
#include "engine/net/node/host_access.h"
#include "engine/net/node/host_driver.h"
#include "engine/session/facts/fact_codec.h"
#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QFile>
#include <QNetworkInterface>

#include <atomic>

namespace carina::node_entry_test
{
namespace
{

/// Counts how often a key is derived.
struct Derivations {
    std::atomic<int> count = 0;

    [[nodiscard]] DeriveKey counted()
    {
        return [this](const JoinCode& code, const SessionKey& session) {
            ++count;
            return cheapKey(code, session);
        };
    }
};

struct Greeted {
    ParticipantId self;
    std::optional<Error> refusal;
};

/// Says Hello in a role over a path that proved something; what comes of it.
Greeted greet(HostDriver& host, const Credential& proved, Role role)
{
    constexpr PeerAddress kGuest = 7;
    constexpr PeerAddress kPathToHost = 1;
    NodeBoard board;
    LocalTime now = monotonicNow();
    ClientDriver guest{{.participantName = "Mallory", .role = role}, board, now};
    host.connected(kGuest, proved, now);
    guest.connected(kPathToHost, {}, now);
    for (int turn = 0; turn < 100; ++turn, now += 1ms) {
        for (const auto& [to, bytes] : guest.advance(now))
            host.receive(kGuest, bytes, now);
        host.waitForDisk(now);
        for (const auto& [to, bytes] : host.advance(now))
            guest.receive(kPathToHost, bytes, now);
    }
    host.disconnected(kGuest, now);
    return {board.part(&NodeBoard::View::self), board.part(&NodeBoard::View::refusal)};
}

std::vector<std::byte> datagramOf(const WireRecord& record)
{
    BundleHeader header;
    header.connection = 1;
    return packDatagrams(std::span{&record, 1}, [&] { return header; }).front();
}

/// A datagram in which a trainee of this name says Hello with this id.
std::vector<std::byte> hello(ProposalId id, const char* name)
{
    const fact::ParticipantJoined joined{ParticipantId{}, Role::Trainee, name};
    return datagramOf(Hello{{}, {}, toRecord(Proposal{id, kNobody, kStation, joined})});
}

} // namespace

class TestNodeEntry : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void wrongCodeIsRefusedAndNotTriedForEver()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        JoinSettings settings = joinSettings(*instructor, "Anna");
        settings.code = JoinCode::random();
        const auto anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal().has_value(), kPatience_ms);
        QCOMPARE(*anna->refusal(), (Error{Errc::WrongCode, settings.code->text()}));
        QCOMPARE(anna->self(), kNobody);
        QCOMPARE(instructor->state()->participants().size(), std::size_t{1});
    }

    void traineesCodeMakesNoInstructor()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        JoinSettings settings = joinSettings(*instructor, "Anna", Role::Instructor);
        settings.code = instructor->joinCodes().at(Role::Trainee);
        const auto anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal().has_value(), kPatience_ms);
        QCOMPARE(anna->refusal()->code, Errc::WrongCode);
    }

    void roleAndNameAreHeldAgainstWhatWasProved()
    {
        const auto access = HostAccess::open({}, std::string(32, '0'), cheapKey);
        QVERIFY(access);
        constexpr ParticipantId kAnna{3};
        constexpr ParticipantId kBen{4};
        (*access)->connected(7, {Role::Trainee, std::nullopt});
        (*access)->connected(8, {Role::Trainee, kAnna});
        QVERIFY((*access)->check(7, Role::Trainee, kBen));
        QVERIFY((*access)->check(8, Role::Trainee, kAnna));
        for (const auto& refused :
             {(*access)->check(7, Role::Instructor, kBen), (*access)->check(8, Role::Trainee, kBen),
              (*access)->check(8, Role::Observer, kAnna), (*access)->check(9, Role::Trainee, kBen)})
            QCOMPARE(refused.error().code, Errc::NotPermitted);
        (*access)->disconnected(7);
        QVERIFY(!(*access)->check(7, Role::Trainee, kBen));
    }

    void provedRoleIsTheOnlyOneToComeInAs()
    {
        MemoryDisk disk;
        NodeBoard board;
        const auto host = HostDriver::open(hostSettings(disk), std::make_unique<MemoryStore>(disk),
                                           board, monotonicNow());
        QVERIFY(host);
        const Credential byCode{Role::Trainee, std::nullopt};
        QCOMPARE(greet(**host, byCode, Role::Instructor).refusal->code, Errc::NotPermitted);
        QCOMPARE(greet(**host, byCode, Role::Observer).refusal->code, Errc::NotPermitted);
        const auto admitted = greet(**host, byCode, Role::Trainee);
        QVERIFY(!admitted.refusal);
        QVERIFY(admitted.self != kNobody);
        const Credential byToken{Role::Trainee, admitted.self};
        QCOMPARE(greet(**host, byToken, Role::Trainee).self, admitted.self);
        const Credential anothersToken{Role::Trainee, ParticipantId{9}};
        QCOMPARE(greet(**host, anothersToken, Role::Trainee).refusal->code, Errc::NotPermitted);
    }

    void idlePathsOfOneCodeAreReplacedByTheirOwnNewOnes()
    {
        MemoryDisk disk;
        NodeBoard board;
        const LocalTime start = monotonicNow();
        const auto host =
            HostDriver::open(hostSettings(disk), std::make_unique<MemoryStore>(disk), board, start);
        QVERIFY(host);
        constexpr PeerAddress kTrainee = 1000;
        (*host)->connected(kTrainee, {Role::Trainee, std::nullopt}, start);
        for (PeerAddress peer = 1; peer <= HostPaths::kMostIdleOfCode; ++peer)
            (*host)->connected(peer, {Role::Observer, std::nullopt},
                               start + peer * std::chrono::microseconds{1});
        QVERIFY((*host)->takeEnded().empty());
        (*host)->connected(500, {Role::Observer, std::nullopt}, start + 1ms);
        QCOMPARE((*host)->takeEnded(), std::vector<PeerAddress>{1});

        constexpr ParticipantId kAnna{3};
        for (PeerAddress peer = 600; peer <= 600 + HostPaths::kMostIdleOfToken; ++peer)
            (*host)->connected(peer, {Role::Observer, kAnna}, start + peer * 1us);
        QCOMPARE((*host)->takeEnded(), std::vector<PeerAddress>{600});
    }

    void pathsWithoutAParticipantAreEnded()
    {
        MemoryDisk disk;
        NodeBoard board;
        const LocalTime start = monotonicNow();
        const auto host =
            HostDriver::open(hostSettings(disk), std::make_unique<MemoryStore>(disk), board, start);
        QVERIFY(host);
        (*host)->connected(5, {Role::Trainee, std::nullopt}, start);
        static_cast<void>((*host)->advance(start + HostPaths::kHelloWithin - 1ms));
        QVERIFY((*host)->takeEnded().empty());
        static_cast<void>((*host)->advance(start + HostPaths::kHelloWithin));
        QCOMPARE((*host)->takeEnded(), std::vector<PeerAddress>{5});
    }

    /// Such a path counted as younger than all others for up to ten seconds.
    void pathOfWhoCameAndWentAtOnceIsIdleFromThenOn()
    {
        MemoryDisk disk;
        NodeBoard board;
        const LocalTime start = monotonicNow();
        const auto host =
            HostDriver::open(hostSettings(disk), std::make_unique<MemoryStore>(disk), board, start);
        QVERIFY(host);
        constexpr PeerAddress kAnna = 5;
        (*host)->connected(kAnna, {Role::Trainee, std::nullopt}, start);
        (*host)->receive(kAnna, hello(ProposalId{20}, "Anna"), start);
        static_cast<void>((*host)->advance(start));
        (*host)->waitForDisk(start);
        static_cast<void>((*host)->advance(start));
        QVERIFY(board.part(&NodeBoard::View::state)->isPresent(ParticipantId{1}));
        (*host)->receive(kAnna, datagramOf(Goodbye{}), start + 1ms);
        static_cast<void>((*host)->advance(start + HostPaths::kHelloWithin));
        QCOMPARE((*host)->takeEnded(), std::vector<PeerAddress>{kAnna});
    }

    void idOfAnothersProposalBringsANewcomerInAsItself()
    {
        MemoryDisk disk;
        NodeBoard board;
        const LocalTime now = monotonicNow();
        const auto host =
            HostDriver::open(hostSettings(disk), std::make_unique<MemoryStore>(disk), board, now);
        QVERIFY(host);
        constexpr ProposalId kEverybodyKnows{20};
        constexpr PeerAddress kAnna = 5;
        constexpr PeerAddress kMallory = 6;
        (*host)->connected(kAnna, {Role::Trainee, std::nullopt}, now);
        (*host)->receive(kAnna, hello(kEverybodyKnows, "Anna"), now);
        (*host)->connected(kMallory, {Role::Trainee, std::nullopt}, now);
        (*host)->receive(kMallory, hello(kEverybodyKnows, "Mallory"), now);
        static_cast<void>((*host)->advance(now));
        (*host)->waitForDisk(now);
        static_cast<void>((*host)->advance(now));
        std::vector<std::string> names;
        for (const auto& [id, participant] : board.part(&NodeBoard::View::state)->participants())
            names.push_back(participant.name);
        QCOMPARE(names, (std::vector<std::string>{"Dr Hall", "Anna", "Mallory"}));
    }

    void observersChangeNothing()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        const auto olga = join(*instructor, "Olga", Role::Observer);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*olga), kPatience_ms);
        const std::size_t facts = disk.facts.size();
        olga->propose(kStation, fact::BreathingRateSet{perMinute(12.0)});
        QTRY_VERIFY_WITH_TIMEOUT(olga->refusal().has_value(), kPatience_ms);
        QCOMPARE(olga->refusal()->code, Errc::NotPermitted);
        olga->publish(ObjectKind::Tube, "Tube", stillTube(*olga));
        QTRY_VERIFY_WITH_TIMEOUT(olga->pending().empty(), kPatience_ms);
        QVERIFY(instructor->state()->objects().empty());
        QCOMPARE(disk.facts.size(), facts);
    }

    void participantsComeBackByTheirTokensAfterTheHostCrashed()
    {
        MemoryDisk disk;
        const QTemporaryDir tokens;
        Derivations derivations;
        auto instructor = host(disk);
        const std::uint16_t port = instructor->port();
        const JoinCodes codes = instructor->joinCodes();
        JoinSettings settings = joinSettings(*instructor, "Anna");
        settings.tokens = tokens.path().toStdString();
        settings.derive = derivations.counted();
        auto anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        const ParticipantId id = anna->self();
        QCOMPARE(derivations.count.load(), 1);
        QTRY_VERIFY_WITH_TIMEOUT(!QDir{tokens.path()}.isEmpty(), kPatience_ms);

        instructor.reset();
        anna.reset();
        settings.code.reset(); // the token alone has to do
        HostSettings again = hostSettings(disk, port);
        again.derive = derivations.counted();
        instructor = *SessionNode::host(again, std::make_unique<MemoryStore>(disk));
        QVERIFY(instructor->joinCodes() == codes);
        anna = join(settings);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        QCOMPARE(anna->self(), id);
        QCOMPARE(derivations.count.load(), 1); // neither of them derived anything
    }

    void lostSecretsAreReplacedAndCodesWithThem()
    {
        MemoryDisk disk;
        auto instructor = host(disk);
        const JoinCodes codes = instructor->joinCodes();
        instructor.reset();
        QVERIFY(QFile::remove(disk.folder.filePath(QStringLiteral("secrets.json"))));
        instructor = host(disk);
        QVERIFY(instructor->joinCodes() != codes);
        const auto anna = join(*instructor, "Anna");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
    }

    void hostWithoutMemoryForKeysSaysSo()
    {
        MemoryDisk disk;
        HostSettings settings = hostSettings(disk);
        settings.derive = [](const JoinCode&, const SessionKey&) -> Result<AccessKey> {
            return fail(Errc::NotEnoughMemory, "256 MiB");
        };
        const auto instructor = *SessionNode::host(settings, std::make_unique<MemoryStore>(disk));
        instructor->propose(kStation, fact::BreathingRateSet{perMinute(12.0)});
        QTRY_VERIFY_WITH_TIMEOUT(instructor->refusal().has_value(), kPatience_ms);
        QCOMPARE(*instructor->refusal(), (Error{Errc::NotEnoughMemory, "256 MiB"}));
    }

    void addressesThatAreNoneAreRefused()
    {
        MemoryDisk disk;
        const auto instructor = host(disk);
        JoinSettings settings = joinSettings(*instructor, "Anna");
        settings.address = "somewhere";
        const auto anna = SessionNode::join(settings);
        QVERIFY(!anna);
        QCOMPARE(anna.error(), (Error{Errc::WrongAddress, "somewhere"}));
    }

    void openHostIsReachedAtAllItsAddresses()
    {
        MemoryDisk disk;
        HostSettings settings = hostSettings(disk);
        settings.open = true;
        const auto instructor = *SessionNode::host(settings, std::make_unique<MemoryStore>(disk));
        QVERIFY(instructor->isOpen());
        for (const QHostAddress& address : QNetworkInterface::allAddresses()) {
            if (address.isLinkLocal())
                continue;
            const std::string text = address.toString().toStdString();
            JoinSettings guest = joinSettings(*instructor, text.c_str());
            guest.address = text;
            const auto anna = join(guest);
            QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna), kPatience_ms);
        }
    }
};

CARINA_TEST(TestNodeEntry)

} // namespace carina::node_entry_test

#include "tst_node_entry.moc"
