#include "engine/session/facts/fact_rules.h"
#include "engine/session/news_rules.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

#include <QTest>

namespace carina::test::news_rules_test
{
namespace
{

using namespace std::chrono_literals;

constexpr StationId kSecondStation{1};

QByteArray judged(const LogWriter& writer, ParticipantId author, const FactBody& body,
                  StationId station = kSampleStation)
{
    return verdict(judgeBy(SessionAuthority{writer.log()}, author, body, station));
}

} // namespace

class TestNewsRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void aRegistrationIsStatedOnceForEachStay()
    {
        const fact::RegistrationStated good{{RegistrationState::Good, {}, millimetres(2.0)}};
        const fact::RegistrationStated worse{{RegistrationState::Good, {}, millimetres(2.5)}};
        LogWriter writer = sampleSession();
        QCOMPARE(judged(writer, kSampleTrainee, good), QByteArray{"fine"});
        writer.add(kNow, good, kSampleStation, kSampleTrainee);
        QCOMPARE(judged(writer, kSampleTrainee, good), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleOtherTrainee, good), QByteArray{"fine"});
        QCOMPARE(judged(writer, kSampleTrainee, worse), QByteArray{"fine"});
        writer.add(kNow, fact::ParticipantJoined{kSampleTrainee, Role::Trainee, "Tom"});
        QCOMPARE(judged(writer, kSampleTrainee, good), QByteArray{"fine"});
    }

    void aPlaceIsChosenWhereItIsAnother()
    {
        const fact::PlaceChosen beside{kSampleTrainee, degrees(90.0)};
        LogWriter writer = sampleSession();
        QCOMPARE(judged(writer, kSampleTrainee, fact::PlaceChosen{kSampleTrainee, {}}),
                 QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleTrainee, beside), QByteArray{"fine"});
        writer.add(kNow, beside);
        for (const ParticipantId who : {kSampleTrainee, kSampleInstructor})
            QCOMPARE(judged(writer, who, beside), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleTrainee, fact::PlaceChosen{kSampleTrainee, {}}),
                 QByteArray{"fine"});
    }

    void anObjectIsAskedForOnceAndHandedToAnother()
    {
        LogWriter writer = sampleSession();
        const fact::ObjectWanted wanted{kSampleTube};
        const fact::ObjectWanted noMore{kSampleTube, false};
        QCOMPARE(judged(writer, kSampleOtherTrainee, noMore), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleOtherTrainee, wanted), QByteArray{"fine"});
        writer.add(kNow, wanted, kSampleStation, kSampleOtherTrainee);
        QCOMPARE(judged(writer, kSampleOtherTrainee, wanted), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleOtherTrainee, noMore), QByteArray{"fine"});
        QCOMPARE(judged(writer, kSampleInstructor, wanted), QByteArray{"fine"});
        const fact::ObjectHandedOver kept{kSampleTube, kSampleTrainee, 1};
        const fact::ObjectHandedOver given{kSampleTube, kSampleOtherTrainee, 1};
        QCOMPARE(judged(writer, kSampleTrainee, kept), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleTrainee, given), QByteArray{"fine"});
    }

    /// Whoever hears it: two programs at one manikin hear the same breath.
    void aManikinBreathesNoFasterThanItCanBeSet()
    {
        LogWriter writer = sampleSession();
        writer.add(kNow, fact::StationAdded{"Station 2"}, kSecondStation);
        writer.add(kNow, fact::ManikinBreathed{kNow - 2s});
        const auto heard = [&](SessionTime began, ParticipantId who = kSampleTrainee) {
            return judged(writer, who, fact::ManikinBreathed{began});
        };
        const Duration fastest = fromSeconds(60.0 / inPerMinute(kFastestBreathing));
        QCOMPARE(heard(kNow - 2s), QByteArray{"out of range"});
        QCOMPARE(heard(kNow - 2s + fastest / 2), QByteArray{"out of range"});
        QCOMPARE(heard(kNow - 2s + fastest / 2, kSampleInstructor), QByteArray{"out of range"});
        QCOMPARE(heard(kNow - 3s), QByteArray{"out of range"}); // before the last
        QCOMPARE(heard(kNow - 2s + fastest), QByteArray{"fine"});
        QCOMPARE(
            judged(writer, kSampleInstructor, fact::ManikinBreathed{kNow - 2s}, kSecondStation),
            QByteArray{"fine"});
    }

    void aCuffAndAStyletChangeOnce()
    {
        LogWriter writer = sampleSession();
        QCOMPARE(judged(writer, kSampleTrainee, fact::CuffSet{false}), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleTrainee, fact::CuffSet{true}), QByteArray{"fine"});
        writer.add(kNow, fact::CuffSet{true});
        QCOMPARE(judged(writer, kSampleTrainee, fact::CuffSet{true}), QByteArray{"out of range"});
        QCOMPARE(judged(writer, kSampleTrainee, fact::CuffSet{false}), QByteArray{"fine"});
        QCOMPARE(judged(writer, kSampleTrainee, fact::StyletDrawn{}), QByteArray{"fine"});
        writer.add(kNow, fact::StyletDrawn{});
        QCOMPARE(judged(writer, kSampleTrainee, fact::StyletDrawn{}), QByteArray{"out of range"});
        writer.add(kNow, fact::IntubationNoted{{.step = IntubationStep::TubeOut, .at = kNow}});
        QCOMPARE(judged(writer, kSampleTrainee, fact::StyletDrawn{}), QByteArray{"fine"});
    }

    void aTryIsNotEndedTwiceBeforeItEnds()
    {
        LogWriter writer = sampleSession();
        QCOMPARE(judged(writer, kSampleTrainee, fact::TryEnded{}), QByteArray{"fine"});
        writer.add(kNow + 1ms, fact::TryEnded{});
        QCOMPARE(judged(writer, kSampleInstructor, fact::TryEnded{}), QByteArray{"out of range"});
        LogWriter later = sampleSession();
        later.add(kNow, fact::TryEnded{});
        QCOMPARE(judged(later, kSampleInstructor, fact::TryEnded{}), QByteArray{"fine"});
    }

    void aStepOfAnIntubationIsOfThePresentAndNotRepeated()
    {
        LogWriter writer = sampleSession();
        const auto noted = [&](IntubationStep step, SessionTime at) {
            return judged(writer, kSampleTrainee, fact::IntubationNoted{{.step = step, .at = at}});
        };
        const SessionTime effect = kNow + kShortestLead;
        QCOMPARE(noted(IntubationStep::BladeIn, effect - kLongestNews), QByteArray{"fine"});
        QCOMPARE(noted(IntubationStep::BladeIn, effect - kLongestNews - 1ns),
                 QByteArray{"out of range"});
        QCOMPARE(noted(IntubationStep::BladeIn, effect), QByteArray{"fine"});
        QCOMPARE(noted(IntubationStep::BladeIn, effect + 1ns), QByteArray{"out of range"});
        writer.add(kNow - 2s, fact::IntubationNoted{{IntubationStep::BladeIn, kNow - 2s}});
        QCOMPARE(noted(IntubationStep::BladeIn, kNow - 2s), QByteArray{"out of range"});
        QCOMPARE(noted(IntubationStep::BladeIn, kNow - 2s + kShortestStep - 1ns),
                 QByteArray{"out of range"});
        QCOMPARE(noted(IntubationStep::BladeIn, kNow - 2s + kShortestStep), QByteArray{"fine"});
        QCOMPARE(noted(IntubationStep::BladeOut, kNow - 2s), QByteArray{"fine"});
    }

    /// One that has no effect on the breathing is not heard either.
    void aBreathIsOfThePresent()
    {
        const LogWriter writer = sampleSession();
        const auto heard = [&](SessionTime began) {
            return judged(writer, kSampleTrainee, fact::ManikinBreathed{began});
        };
        QCOMPARE(heard(SessionTime{}), QByteArray{"out of range"});
        QCOMPARE(heard(kNow + kShortestLead - kLongestNews), QByteArray{"fine"});
        QCOMPARE(heard(kNow + kShortestLead - kLongestNews - 1ns), QByteArray{"out of range"});
        QCOMPARE(heard(kNow + kShortestLead), QByteArray{"fine"});
        QCOMPARE(heard(kNow + kShortestLead + 1ns), QByteArray{"out of range"});
    }

    /// As many in a minute as the fastest breathing has, and a tenth, however many are proposed.
    void aFloodOfBreathsIsOneForEachBreath()
    {
        LogWriter writer = sampleSession();
        SessionAuthority authority{writer.log()};
        int entered = 0;
        std::uint64_t number = 5000;
        for (SessionTime now = kNow; now < kNow + 60s; now += 50ms) {
            const auto fact = authority.judge(
                {ProposalId{++number}, kSampleTrainee, kSampleStation, fact::ManikinBreathed{now}},
                now, kNear);
            if (!fact)
                continue;
            authority.commit(*fact);
            ++entered;
        }
        QVERIFY2(entered >= 60 && entered <= 67, qPrintable(QString::number(entered)));
    }
};

CARINA_TEST(TestNewsRules)

} // namespace carina::test::news_rules_test

#include "tst_news_rules.moc"
