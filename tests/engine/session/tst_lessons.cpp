#include "engine/session/facts/fact_codec.h"
#include "engine/session/lesson_rules.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

#include <QTest>

#include <limits>

namespace carina::test::lessons_test
{
namespace
{

using namespace std::chrono_literals;

constexpr StationId kSecondStation{1};
constexpr std::size_t kLargestBody = 1024; ///< bytes (docs/protocol.md)
const fact::ParticipantJoined kComesIn{kSampleInstructor, Role::Instructor, "Ina"};

Lesson sampleLesson()
{
    return {{true, LessonCut::All, {0.0, -1.0, 0.0}, 0.01},
            true,
            {{2, 4, LessonStyle::Hidden}, {7, 7, LessonStyle::AsUsual, true}}};
}

QByteArray judged(const LogWriter& writer, ParticipantId author, const FactBody& body,
                  StationId station = kSampleStation)
{
    return verdict(judgeBy(SessionAuthority{writer.log()}, author, body, station));
}

void show(LogWriter& writer, ParticipantId to, ParticipantId by = kSampleInstructor)
{
    writer.add(kNow, fact::LessonShown{to, sampleLesson()}, kSampleStation, by);
}

bool isShown(const LogWriter& writer, ParticipantId participant)
{
    const SessionState state = stateOf(writer);
    const ShownLesson* shown = lessonFor(state, participant);
    return shown && shown->by == kSampleInstructor && shown->lesson == sampleLesson();
}

std::optional<BrokenOffLesson> brokenOff(const LogWriter& writer)
{
    return stateOf(writer).stations().at(kSampleStation).brokenOff;
}

QByteArray verdictOn(const Lesson& lesson)
{
    return judged(sampleSession(), kSampleInstructor, fact::LessonShown{kNobody, lesson});
}

} // namespace

class TestLessons : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isShownToEverybodyButItsAuthor()
    {
        LogWriter writer = sampleSession();
        QVERIFY(!isShown(writer, kSampleTrainee));
        show(writer, kNobody);
        for (const ParticipantId who : {kSampleTrainee, kSampleOtherTrainee, kSampleObserver})
            QVERIFY(isShown(writer, who));
        QVERIFY(!isShown(writer, kSampleInstructor));
        QVERIFY(!isShown(writer, ParticipantId{99}));
    }

    void isShownToNobodyElseThanItsTarget()
    {
        LogWriter writer = sampleSession();
        show(writer, kSampleTrainee);
        QVERIFY(isShown(writer, kSampleTrainee));
        QVERIFY(!isShown(writer, kSampleOtherTrainee));
        QVERIFY(!isShown(writer, kSampleObserver));
    }

    void isShownToWhoeverJoinsLater()
    {
        LogWriter writer = sampleSession();
        show(writer, kNobody);
        const ParticipantId late{5};
        writer.add(kNow, fact::ParticipantJoined{late, Role::Trainee, "Lea"});
        QVERIFY(isShown(writer, late));
        writer.add(kNow, fact::ParticipantLeft{kSampleTrainee});
        writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
        QVERIFY(isShown(writer, kSampleTrainee));
    }

    void isOfItsStationAlone()
    {
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::StationAdded{"Room 5"}, kSecondStation);
        show(writer, kNobody);
        writer.add(kNow, fact::ParticipantMoved{kSampleTrainee}, kSecondStation);
        QVERIFY(!isShown(writer, kSampleTrainee));
        QVERIFY(isShown(writer, kSampleOtherTrainee));
    }

    void endsWhenItsAuthorSaysSoOrIsGone_data()
    {
        QTest::addColumn<FactBody>("body");
        QTest::addColumn<int>("station");
        const auto row = [](const char* name, const FactBody& body,
                            StationId station = kSampleStation) {
            QTest::newRow(name) << body << int(station.value);
        };
        row("ended", fact::LessonEnded{});
        row("left", fact::ParticipantLeft{kSampleInstructor});
        row("removed", fact::ParticipantRemoved{kSampleInstructor, false, ""});
        row("came in anew", fact::ParticipantJoined{kSampleInstructor, Role::Instructor, "Ina"});
        row("went elsewhere", fact::ParticipantMoved{kSampleInstructor}, kSecondStation);
        row("another patient", fact::AnatomyChosen{"bb", "Child"});
    }

    void endsWhenItsAuthorSaysSoOrIsGone()
    {
        QFETCH(const FactBody, body);
        QFETCH(const int, station);
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::StationAdded{"Room 5"}, kSecondStation);
        show(writer, kNobody);
        QVERIFY(isShown(writer, kSampleTrainee));
        writer.add(kNow, body, StationId{std::uint16_t(station)}, kSampleInstructor);
        QVERIFY(!isShown(writer, kSampleTrainee));
    }

    /// As the host's program does when it is started again: there is no fact that it stopped.
    void breaksOffWhereItsAuthorComesInAnew()
    {
        LogWriter writer = sampleSession();
        show(writer, kSampleTrainee);
        QVERIFY(!brokenOff(writer));
        writer.add(kNow + 5s, kComesIn);
        const auto told = brokenOff(writer);
        QVERIFY(told && told->at == kNow + 5s);
        QVERIFY(told->shown == (ShownLesson{kSampleInstructor, kSampleTrainee, sampleLesson()}));
        writer.add(kNow + 6s, fact::ParticipantLeft{kSampleTrainee});
        QVERIFY(brokenOff(writer) == told);
        writer.add(kNow + 7s, kComesIn); // and has heard of it before
        QVERIFY(!brokenOff(writer));
    }

    void breaksOffWhereItsAuthorLeavesUntilTheyAreBack()
    {
        LogWriter writer = sampleSession();
        show(writer, kNobody);
        writer.add(kNow + 1s, fact::ParticipantLeft{kSampleInstructor});
        QVERIFY(brokenOff(writer));
        writer.add(kNow + 9s, kComesIn);
        QVERIFY(brokenOff(writer) && brokenOff(writer)->at == kNow + 9s);
        writer.add(kNow + 20s, fact::ParticipantLeft{kSampleInstructor});
        QVERIFY(!brokenOff(writer));
    }

    void hasNotBrokenOffWhereItWasEndedOrSomethingElseIsShown_data()
    {
        QTest::addColumn<FactBody>("body");
        QTest::addColumn<bool>("isBefore"); // before the author comes in anew
        QTest::newRow("ended") << FactBody{fact::LessonEnded{}} << true;
        QTest::newRow("shown again")
            << FactBody{fact::LessonShown{kNobody, sampleLesson()}} << false;
        QTest::newRow("another patient") << FactBody{fact::AnatomyChosen{"bb", "Child"}} << false;
        QTest::newRow("another patient before")
            << FactBody{fact::AnatomyChosen{"bb", "Child"}} << true;
    }
    void hasNotBrokenOffWhereItWasEndedOrSomethingElseIsShown()
    {
        QFETCH(const FactBody, body);
        QFETCH(const bool, isBefore);
        LogWriter writer = sampleSession();
        show(writer, kNobody);
        if (isBefore)
            writer.add(kNow, body, kSampleStation, kSampleInstructor);
        writer.add(kNow, kComesIn);
        if (!isBefore)
            writer.add(kNow, body, kSampleStation, kSampleInstructor);
        QVERIFY(!brokenOff(writer));
    }

    void whatOthersDoDoesNotEndIt()
    {
        LogWriter writer = sampleSession();
        show(writer, kNobody);
        writer.add(kNow, fact::ParticipantLeft{kSampleOtherTrainee});
        writer.add(kNow, fact::PhaseChanged{SessionPhase::Running});
        QVERIFY(isShown(writer, kSampleTrainee));
    }

    void isShownToParticipantsWhoAreKnownAndNoInstructors()
    {
        const LogWriter writer = sampleSession();
        const auto to = [&](ParticipantId id) {
            return judged(writer, kSampleInstructor, fact::LessonShown{id, {}});
        };
        QCOMPARE(to(kSampleTrainee), QByteArray{"fine"});
        QCOMPARE(to(kSampleObserver), QByteArray{"fine"});
        QCOMPARE(to(ParticipantId{99}), QByteArray{"out of range"});
        QCOMPARE(to(kSampleInstructor), QByteArray{"not permitted"});
        QCOMPARE(judged(writer, kSampleInstructor, fact::LessonShown{}, kAllStations),
                 QByteArray{"station unknown"});
    }

    void saysNothingTwice()
    {
        LogWriter writer = sampleSession();
        const fact::LessonShown shown{kNobody, sampleLesson()};
        QCOMPARE(judged(writer, kSampleInstructor, fact::LessonEnded{}),
                 QByteArray{"out of range"});
        show(writer, kNobody);
        QCOMPARE(judged(writer, kSampleInstructor, shown), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleInstructor, fact::LessonShown{kSampleTrainee, shown.lesson}),
                 QByteArray{"fine"});
        QCOMPARE(judged(writer, kSampleInstructor, fact::LessonEnded{}), QByteArray{"fine"});
        QCOMPARE(judged(writer, kSampleTrainee, fact::LessonEnded{}), QByteArray{"not permitted"});
    }

    void hasAPlaneThatIsOne()
    {
        const auto plane = [](std::array<double, 3> normal_A, double distance) {
            return verdictOn({{true, LessonCut::All, normal_A, distance}, false, {}});
        };
        QCOMPARE(plane({0.6, 0.0, -0.8}, 10.0), QByteArray{"fine"});
        QCOMPARE(plane({0.0, 0.0, 0.0}, 0.0), QByteArray{"out of range"});
        QCOMPARE(plane({0.0, 1.001, 0.0}, 0.0), QByteArray{"out of range"});
        QCOMPARE(plane({1e300, 0.0, 0.0}, 0.0), QByteArray{"not finite"}); // its square is
        QCOMPARE(plane({0.0, 1.0, 0.0}, -10.1), QByteArray{"out of range"});
        QCOMPARE(plane({0.0, 1.0, 0.0}, std::numeric_limits<double>::quiet_NaN()),
                 QByteArray{"not finite"});
    }

    void hasEachPartOnceAndInOrder()
    {
        const auto looks = [](const LessonLooks& of) { return verdictOn({{}, false, of}); };
        QCOMPARE(looks({{1, 1}, {2, 0xffff}}), QByteArray{"fine"});
        QCOMPARE(looks({{0, 1}}), QByteArray{"out of range"});
        QCOMPARE(looks({{3, 2}}), QByteArray{"out of range"});
        QCOMPARE(looks({{1, 5}, {5, 6}}), QByteArray{"out of range"});
        QCOMPARE(looks({{4, 5}, {1, 2}}), QByteArray{"out of range"});
    }

    void theLargestFitsIntoAFact()
    {
        LessonLooks most;
        for (std::uint16_t part = 1; most.size() < kMostLessonLooks; ++part)
            most.push_back({part, part, LessonStyle::Ghost});
        const fact::LessonShown largest{kNobody, {{}, true, most}};
        QCOMPARE(verdictOn(largest.lesson), QByteArray{"fine"});
        QVERIFY(encodeBody(largest).size() <= kLargestBody);
        most.push_back({200, 200});
        QCOMPARE(verdictOn({{}, true, most}), QByteArray{"out of range"});
    }
};

CARINA_TEST(TestLessons)

} // namespace carina::test::lessons_test

#include "tst_lessons.moc"
