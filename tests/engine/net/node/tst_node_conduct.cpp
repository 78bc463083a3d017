#include "engine/net/node/client_driver.h"
#include "engine/net/node/host_access.h"
#include "engine/net/node/host_driver.h"
#include "engine/sync/wire/datagram_codec.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

#include <atomic>

namespace carina::node_conduct_test
{
namespace
{

/// A host with a trainee, whose token is on disk.
struct Course {
    MemoryDisk disk;
    QTemporaryDir tokens;
    std::unique_ptr<SessionNode> instructor = host(disk);
    JoinSettings annas = settingsOfAnna();
    std::unique_ptr<SessionNode> anna = join(annas);

    [[nodiscard]] JoinSettings settingsOfAnna() const
    {
        JoinSettings settings = joinSettings(*instructor, "Anna");
        settings.tokens = tokens.path().toStdString();
        return settings;
    }
    [[nodiscard]] bool isReady() const { return isIn(*anna) && !QDir{tokens.path()}.isEmpty(); }
    [[nodiscard]] Participant asKnown(ParticipantId id) const
    {
        return instructor->state()->participants().at(id);
    }
    void decide(FactBody body) const { instructor->propose(kStation, std::move(body)); }
};

QByteArray onlyFileIn(const QString& folder)
{
    const QDir dir{folder};
    const QStringList files = dir.entryList(QDir::Files);
    QFile file{files.isEmpty() ? QString{} : dir.filePath(files.first())};
    return file.open(QFile::ReadOnly) ? file.readAll() : QByteArray{};
}

/// Of the first path of the host.
TrafficReport trafficAt(const SessionNode& host)
{
    const auto paths = host.paths();
    return paths->empty() ? TrafficReport{} : paths->front().traffic.value();
}

std::optional<Errc> refusalOf(const SessionNode& node)
{
    const auto refusal = node.refusal();
    return refusal ? std::optional{refusal->code} : std::nullopt;
}

} // namespace

/// Instructors mute, remove, ban, lock and change codes; tokens that two have are replaced.
class TestNodeConduct : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void removedParticipantReadsByWhomAndWhy()
    {
        Course course;
        const auto ina = join(*course.instructor, "Ina", Role::Instructor);
        QTRY_VERIFY_WITH_TIMEOUT(course.isReady() && isIn(*ina), kPatience_ms);
        const ParticipantId id = course.anna->self();
        ina->propose(kStation, fact::ParticipantRemoved{id, false, "too loud"});
        QTRY_COMPARE_WITH_TIMEOUT(linkOf(*course.anna), LinkState::Ended, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*course.anna), std::optional{Errc::Removed},
                                  kPatience_ms);
        QCOMPARE(course.anna->refusal()->detail, std::string{"Ina: too loud"});
        QVERIFY(!course.asKnown(id).present);
        QCOMPARE(course.instructor->paths()->empty(), false); // Ina's
        // Another run of her program comes in; that one does not.
        const auto again = join(course.annas);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*again), kPatience_ms);
        QCOMPARE(again->self(), id);
        QVERIFY(!course.asKnown(id).removal && !course.asKnown(id).tokenReplaced);
        QCOMPARE(linkOf(*course.anna), LinkState::Ended);
    }

    /// The host's word is lost: the program asks again over its path, and is told again.
    void removedParticipantReadsItThoughTheFirstWordIsLost()
    {
        constexpr PeerAddress kGuest = 7;
        MemoryDisk disk;
        NodeBoard boards[2];
        LocalTime now = monotonicNow();
        const auto host = HostDriver::open(hostSettings(disk), std::make_unique<MemoryStore>(disk),
                                           boards[0], now);
        ClientDriver guest{{.participantName = "Anna"}, boards[1], now};
        (*host)->connected(kGuest, {Role::Trainee, {}}, now);
        guest.connected(kGuest, {}, now);
        const auto talk = [&](Duration length) {
            for (const LocalTime end = now + length; now < end; now += 1ms) {
                for (const auto& [to, bytes] : guest.advance(now))
                    (*host)->receive(kGuest, bytes, now);
                (*host)->waitForDisk(now);
                for (const auto& [to, bytes] : (*host)->advance(now))
                    guest.receive(kGuest, bytes, now);
            }
        };
        talk(500ms);
        const ParticipantId id = boards[1].part(&NodeBoard::View::self);
        QVERIFY(id != kNobody);
        (*host)->propose(kStation, fact::ParticipantRemoved{id, false, "too loud"}, now);
        (*host)->waitForDisk(now);
        static_cast<void>((*host)->advance(now)); // lost
        QVERIFY((*host)->takeEnded().empty());
        talk(1s);
        QCOMPARE(boards[1].part(&NodeBoard::View::links)->at(0).report.state, LinkState::Ended);
        QCOMPARE(*boards[1].part(&NodeBoard::View::refusal),
                 (Error{Errc::Removed, "Dr Hall: too loud"}));
        QVERIFY(!boards[0].state()->participants().at(id).present);
        talk(HostPaths::kHelloWithin);
        QCOMPARE((*host)->takeEnded(), std::vector<PeerAddress>{kGuest});
    }

    void bannedParticipantComesInByNothingUntilTheBanIsLifted()
    {
        Course course;
        QTRY_VERIFY_WITH_TIMEOUT(course.isReady(), kPatience_ms);
        const ParticipantId id = course.anna->self();
        course.decide(fact::ParticipantRemoved{id, true, "too loud"});
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*course.anna), std::optional{Errc::Banned},
                                  kPatience_ms);
        course.anna = join(course.annas); // by the token, which is void, and then by the code
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*course.anna), std::optional{Errc::Banned},
                                  kPatience_ms);
        QCOMPARE(course.anna->refusal()->detail, std::string{"Dr Hall: too loud"});
        JoinSettings byToken = course.annas;
        byToken.code.reset();
        const auto withToken = join(byToken);
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*withToken), std::optional{Errc::WrongCode},
                                  kPatience_ms);
        course.decide(fact::BanLifted{id});
        QTRY_VERIFY_WITH_TIMEOUT(!course.asKnown(id).removal->banned, kPatience_ms);
        course.anna = join(course.annas);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*course.anna), kPatience_ms);
        QCOMPARE(course.anna->self(), id);
    }

    void lockedSessionTakesThoseWithATokenOnly()
    {
        Course course;
        QTRY_VERIFY_WITH_TIMEOUT(course.isReady(), kPatience_ms);
        course.decide(fact::SessionLocked{true});
        QTRY_VERIFY_WITH_TIMEOUT(course.instructor->state()->isLocked(), kPatience_ms);
        const auto ben = join(*course.instructor, "Ben");
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*ben), std::optional{Errc::SessionLocked},
                                  kPatience_ms);
        course.anna = join(course.annas);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*course.anna), kPatience_ms);
        QCOMPARE(ben->self(), kNobody);
        course.decide(fact::SessionLocked{false});
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*ben), kPatience_ms);
        QVERIFY(!ben->refusal());
        // Whose token is void proves nothing, though the name is known.
        course.decide(fact::ParticipantRemoved{course.anna->self(), true, {}});
        course.decide(fact::BanLifted{course.anna->self()});
        course.decide(fact::SessionLocked{true});
        course.anna = join(course.annas);
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*course.anna), std::optional{Errc::SessionLocked},
                                  kPatience_ms);
    }

    void mutedParticipantSeesAndChangesNothing()
    {
        Course course;
        course.anna->publish(ObjectKind::Tube, "Tube", stillTube(*course.anna));
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*course.instructor)
                                     && onlyObject(*course.instructor)->newest(),
                                 kPatience_ms);
        const ParticipantId id = course.anna->self();
        const ObjectId tube = course.instructor->state()->objects().begin()->first;
        course.decide(fact::ParticipantMuted{id, true});
        QTRY_VERIFY_WITH_TIMEOUT(course.anna->state()->participants().at(id).muted, kPatience_ms);
        const std::size_t facts = course.instructor->state()->lastApplied().value;
        course.anna->propose(kStation, fact::ObjectWanted{tube});
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*course.anna), std::optional{Errc::Muted},
                                  kPatience_ms);
        course.anna->act(tube, {ActionKind::Rotation, Vec3::UnitZ(), 0.5, {}});
        course.anna->publish(ObjectKind::Stylus, "Stylus", stillTube(*course.anna));
        QTRY_VERIFY_WITH_TIMEOUT(course.anna->pending().empty(), kPatience_ms);
        QVERIFY(!course.anna->shown(tube, *course.anna->now()));
        QCOMPARE(course.instructor->state()->lastApplied().value, facts);
        const auto newest = onlyObject(*course.instructor)->newest();
        course.decide(fact::BreathingRateSet{perMinute(20.0)}); // which she sees
        QTRY_COMPARE_WITH_TIMEOUT(ratePerMinute(*course.anna), 20.0, kPatience_ms);
        QCOMPARE(onlyObject(*course.instructor)->newest()->time, newest->time);
        course.decide(fact::ParticipantMuted{id, false});
        QTRY_VERIFY_WITH_TIMEOUT(!course.anna->refusal(), kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(course.instructor->state()->objects().size(), std::size_t{2},
                                  kPatience_ms); // what was refused is proposed again
        QTRY_VERIFY_WITH_TIMEOUT(course.instructor->object(tube)->newest()->time > newest->time,
                                 kPatience_ms);
    }

    void changedCodeLetsNobodyInByTheOldOne()
    {
        Course course;
        QTRY_VERIFY_WITH_TIMEOUT(course.isReady(), kPatience_ms);
        const JoinCodes before = course.instructor->joinCodes();
        course.decide(fact::RoleCodeChanged{Role::Trainee});
        QTRY_VERIFY_WITH_TIMEOUT(course.instructor->joinCodes() != before, kPatience_ms);
        const JoinCodes after = course.instructor->joinCodes();
        QVERIFY(after.at(Role::Trainee) != before.at(Role::Trainee));
        QVERIFY(after.at(Role::Observer) == before.at(Role::Observer));
        QVERIFY(after.at(Role::Instructor) == before.at(Role::Instructor));
        JoinSettings late = joinSettings(*course.instructor, "Ben");
        late.code = before.at(Role::Trainee);
        const auto ben = join(late);
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*ben), std::optional{Errc::WrongCode}, kPatience_ms);
        const auto carl = join(*course.instructor, "Carl");
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*carl), kPatience_ms);
        QVERIFY(isIn(*course.anna)); // inside stays, and comes back by the token
        course.anna = join(course.annas);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*course.anna), kPatience_ms);
        course.instructor.reset();
        QVERIFY(host(course.disk)->joinCodes() == after);
    }

    void codeIsNotChangedWhereItCannotBeKept()
    {
        Course course;
        QTRY_VERIFY_WITH_TIMEOUT(course.isReady(), kPatience_ms);
        const JoinCodes before = course.instructor->joinCodes();
        const FactNumber last = course.instructor->state()->lastApplied();
        const QString folder = course.disk.folder.path();
        QVERIFY(course.disk.folder.remove());
        QFile inItsPlace{folder};
        QVERIFY(inItsPlace.open(QFile::WriteOnly));
        course.decide(fact::RoleCodeChanged{Role::Trainee});
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*course.instructor), std::optional{Errc::StoreFailed},
                                  kPatience_ms);
        QVERIFY(inItsPlace.remove());
        QVERIFY(course.instructor->joinCodes() == before);
        QCOMPARE(course.instructor->state()->lastApplied(), last);
    }

    /// The keys of the codes are derived on another thread: that of the old code may be done after
    /// the change, and must not be used, whatever becomes of the new one's.
    void keyOfAnOldCodeThatComesLateIsNotUsed()
    {
        const std::string session(32, '0');
        std::atomic<int> derived = 0;
        const auto onlyThree = [&](const JoinCode& code, const SessionKey& key) {
            return ++derived <= 3 ? cheapKey(code, key) : Result<AccessKey>{fail(Errc::Cancelled)};
        };
        const auto access = HostAccess::open({}, session, onlyThree);
        (*access)->changeCode(Role::Trainee);
        const auto stateOf = [&](Role role) {
            return (*access)->keyOf({{role, {}}, session}).state;
        };
        using State = HostTransport::KeyAnswer::State;
        QTRY_VERIFY_WITH_TIMEOUT((*access)->fault().has_value(), kPatience_ms); // the new code's
        QVERIFY(stateOf(Role::Observer) == State::Known);
        QVERIFY(stateOf(Role::Trainee) == State::NotYet);
        (*access)->changeCode(Role::Observer);
        QVERIFY(stateOf(Role::Observer) == State::NotYet); // at once
    }

    void whoHasNotComeInWithAnOldCodeIsOut()
    {
        const auto access = HostAccess::open({}, std::string(32, '0'), cheapKey);
        constexpr ParticipantId kAnna{3};
        for (const PeerAddress peer : {7, 8, 9})
            (*access)->connected(peer, {peer == 9 ? Role::Observer : Role::Trainee, {}});
        (*access)->admitted(7, kAnna);
        (*access)->changeCode(Role::Trainee);
        QVERIFY((*access)->check(7, Role::Trainee, kAnna));
        QVERIFY(!(*access)->check(8, Role::Trainee, ParticipantId{4}));
        QVERIFY((*access)->check(9, Role::Observer, ParticipantId{5}));
    }

    /// Paths that a program keeps idle prove no more than its token does at the moment it comes in.
    void whoHasNotComeInWithAnOldTokenIsOut()
    {
        const auto access = HostAccess::open({}, std::string(32, '0'), cheapKey);
        constexpr ParticipantId kAnna{3};
        const Credential byToken{Role::Trainee, kAnna};
        constexpr PeerAddress kFirst = 5;
        (*access)->connected(kFirst, {Role::Trainee, {}});
        (*access)->admitted(kFirst, kAnna);
        QVERIFY((*access)->issueToken(kFirst, kAnna));
        QVERIFY((*access)->isProven(kFirst)); // who has just been given it

        for (const PeerAddress peer : {7, 8})
            (*access)->connected(peer, byToken);
        const AccessKey token = (*access)->replaceToken(Role::Trainee, kAnna, 7);
        QVERIFY(*(*access)->issueToken(7, kAnna) == token);
        QVERIFY((*access)->check(7, Role::Trainee, kAnna) && (*access)->isProven(7));
        for (const PeerAddress peer : {kFirst, PeerAddress{8}}) {
            QCOMPARE((*access)->check(peer, Role::Trainee, kAnna).error().code,
                     Errc::UsedElsewhere);
            QVERIFY(!(*access)->isProven(peer));
        }

        (*access)->connected(9, byToken);
        (*access)->revokeToken(Role::Trainee, kAnna);
        for (const PeerAddress peer : {7, 9}) {
            QCOMPARE((*access)->check(peer, Role::Trainee, kAnna).error().code, Errc::NotPermitted);
            QVERIFY(!(*access)->isProven(peer));
        }
        (*access)->connected(10, {Role::Trainee, {}});
        QVERIFY((*access)->check(10, Role::Trainee, kAnna)); // by the code, once it is let back in
    }

    /// What cannot be stored is undone, and who was inside stays who they were.
    void tokenThatIsNotRevokedAfterAllProvesAsBefore()
    {
        const auto access = HostAccess::open({}, std::string(32, '0'), cheapKey);
        constexpr ParticipantId kAnna{3};
        (*access)->connected(7, {Role::Trainee, {}});
        (*access)->admitted(7, kAnna);
        QVERIFY((*access)->issueToken(7, kAnna));
        QVERIFY((*access)->write());
        (*access)->revokeToken(Role::Trainee, kAnna);
        QVERIFY(!(*access)->isProven(7));
        (*access)->giveUp();
        QVERIFY((*access)->isProven(7) && (*access)->check(7, Role::Trainee, kAnna));
        static_cast<void>((*access)->replaceToken(Role::Trainee, kAnna, 7));
        QVERIFY((*access)->isProven(7));
        (*access)->giveUp();
        QVERIFY((*access)->isProven(7) && (*access)->check(7, Role::Trainee, kAnna));
    }

    /// Whatever was decided on their ground is undone, too.
    void secretsThatAreNotStoredAreUndone()
    {
        const std::string session(32, '0');
        const auto access = HostAccess::open({}, session, cheapKey);
        const PskIdentity trainee{{Role::Trainee, {}}, session};
        const auto keyNow = [&] { return (*access)->keyOf(trainee).key; };
        QTRY_VERIFY_WITH_TIMEOUT(!(*access)->isDeriving(Role::Trainee), kPatience_ms);
        QVERIFY((*access)->write() && !(*access)->isUnwritten());
        const JoinCodes before = (*access)->codes();
        const AccessKey key = keyNow();
        constexpr ParticipantId kAnna{3};
        const PskIdentity annas{{Role::Trainee, kAnna}, session};
        (*access)->connected(7, {Role::Trainee, kAnna});
        QVERIFY((*access)->issueToken(7, kAnna));
        (*access)->changeCode(Role::Trainee);
        QVERIFY((*access)->isDeriving(Role::Trainee)); // the old key is void at once
        QVERIFY((*access)->isUnwritten());
        QVERIFY((*access)->codes() == before); // nobody reads a code that is not stored
        static_cast<void>((*access)->handOver());
        QVERIFY(!(*access)->isUnwritten());
        (*access)->giveUp();
        QVERIFY((*access)->isUnwritten());
        QVERIFY(keyNow() == key);
        QVERIFY((*access)->keyOf(annas).state == HostTransport::KeyAnswer::State::Unknown);
        static_cast<void>((*access)->handOver());
        (*access)->stored();
        QVERIFY((*access)->codes() == before);
        (*access)->changeCode(Role::Trainee);
        QVERIFY((*access)->write());
        QVERIFY((*access)->codes() != before);
    }

    void tokenThatTwoHaveIsReplacedAndBothAreTold()
    {
        Course course;
        QTRY_VERIFY_WITH_TIMEOUT(course.isReady(), kPatience_ms);
        const ParticipantId id = course.anna->self();
        const QTemporaryDir copied;
        const QString file = QDir{course.tokens.path()}.entryList(QDir::Files).first();
        QVERIFY(QFile::copy(QDir{course.tokens.path()}.filePath(file),
                            QDir{copied.path()}.filePath(file)));
        const QByteArray token = onlyFileIn(copied.path());
        JoinSettings withCopy = course.annas;
        withCopy.tokens = copied.path().toStdString();
        withCopy.code.reset();
        const auto thief = join(withCopy);
        QTRY_COMPARE_WITH_TIMEOUT(linkOf(*course.anna), LinkState::Ended, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*course.anna), std::optional{Errc::UsedElsewhere},
                                  kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(isIn(*thief), kPatience_ms);
        QCOMPARE(thief->self(), id);
        QTRY_VERIFY_WITH_TIMEOUT(thief->state()->participants().at(id).tokenReplaced, kPatience_ms);
        QVERIFY(course.asKnown(id).tokenReplaced);
        QTRY_VERIFY_WITH_TIMEOUT(onlyFileIn(copied.path()) != token, kPatience_ms);
        QCOMPARE(onlyFileIn(course.tokens.path()), token); // which is void
        JoinSettings byOldToken = course.annas;
        byOldToken.code.reset();
        const auto late = join(byOldToken);
        QTRY_COMPARE_WITH_TIMEOUT(refusalOf(*late), std::optional{Errc::WrongCode}, kPatience_ms);
        QVERIFY(isIn(*thief));
    }

    /// Nobody is warned of a program that ends and starts again, as often as it does.
    void restartedProgramIsNoSecondOne()
    {
        Course course;
        QTRY_VERIFY_WITH_TIMEOUT(course.isReady(), kPatience_ms);
        const ParticipantId id = course.anna->self();
        const QByteArray token = onlyFileIn(course.tokens.path());
        for (int i = 0; i < 3; ++i) {
            course.anna = join(course.annas); // the old one ends once the new one has begun
            QTRY_VERIFY_WITH_TIMEOUT(isIn(*course.anna), kPatience_ms);
            QCOMPARE(course.anna->self(), id);
        }
        QVERIFY(!course.asKnown(id).tokenReplaced);
        QCOMPARE(onlyFileIn(course.tokens.path()), token);
    }

    /// The id that a program joins with proves its run, so it must not be in the log.
    void idOfAJoinStaysBetweenAProgramAndItsHost()
    {
        constexpr PeerAddress kGuest = 7;
        MemoryDisk disk;
        NodeBoard boards[2];
        const LocalTime now = monotonicNow();
        const auto host = HostDriver::open(hostSettings(disk), std::make_unique<MemoryStore>(disk),
                                           boards[0], now);
        ClientDriver guest{{.participantName = "Anna"}, boards[1], now};
        (*host)->connected(kGuest, {Role::Trainee, {}}, now);
        guest.connected(kGuest, {}, now);
        std::optional<ProposalId> join;
        for (const auto& [to, bytes] : guest.advance(now)) {
            (*host)->receive(kGuest, bytes, now);
            (*host)->receive(kGuest, bytes, now + 1ms); // a repeated Hello is the same join
            const auto datagram = decodeDatagram(bytes);
            for (const WireRecord& record : datagram->records)
                if (const auto* hello = std::get_if<Hello>(&record))
                    join = hello->join.id;
        }
        QVERIFY(join);
        static_cast<void>((*host)->advance(now));
        (*host)->waitForDisk(now);
        const auto joins = std::ranges::count_if(
            disk.facts, [](const FactRecord& fact) { return fact.author == kNobody; });
        QCOMPARE(joins, 1);
        for (const FactRecord& fact : disk.facts)
            QVERIFY(fact.proposal != *join);
    }

    void hostSeesWhatEverybodySends()
    {
        Course course;
        course.anna->publish(ObjectKind::Tube, "Tube", stillTube(*course.anna));
        const SessionNode& instructor = *course.instructor;
        QTRY_VERIFY_WITH_TIMEOUT(trafficAt(instructor).samplesPerSecond > 20.0, kPatience_ms);
        QVERIFY(trafficAt(instructor).samplesPerSecond < 90.0);
        QVERIFY(trafficAt(instructor).bytesPerSecond
                > 20.0 * trafficAt(instructor).samplesPerSecond);
        QCOMPARE(trafficAt(instructor).facts, std::uint64_t{1}); // that she shares the tube
        QCOMPARE(trafficAt(instructor).refused, std::uint64_t{0});
        course.anna->propose(kStation, fact::BreathingRateSet{perMinute(20.0)});
        QTRY_COMPARE_WITH_TIMEOUT(trafficAt(instructor).refused, std::uint64_t{1}, kPatience_ms);
        QVERIFY(!course.anna->paths()->front().traffic);
    }
};

CARINA_TEST(TestNodeConduct)

} // namespace carina::node_conduct_test

#include "tst_node_conduct.moc"
