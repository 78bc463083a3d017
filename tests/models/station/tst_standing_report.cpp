#include "models/station/standing_report.h"

#include "engine/session/facts/fact_codec.h"
#include "models/session/participants_model.h"
#include "models/site/standing_words.h"
#include "models/station/station_notice.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

#include <cmath>
#include <variant>

namespace carina::standing_report_test
{
namespace
{

using std::chrono::milliseconds;
using test::FakeSessionNode;

constexpr RegistrationStanding kGood{RegistrationState::Good, StaleReason::None, {1.4e-3}};
constexpr RegistrationStanding kNotGood{RegistrationState::NotGood, StaleReason::None, {4.2e-3}};

struct Trainee {
    FakeSessionNode node{FakeSessionNode::kTrainee};
    StandingReport report{node};

    [[nodiscard]] std::optional<RegistrationStanding> known() const
    {
        return node.state()->participants().at(FakeSessionNode::kTrainee).registration;
    }
    /// A running session with the own tube in view.
    [[nodiscard]] StationMoment begin()
    {
        node.linkReports.emplace_back().state = LinkState::Connected;
        node.decide(fact::PhaseChanged{SessionPhase::Running});
        StationMoment moment;
        moment.time = *node.now() + std::chrono::seconds{1};
        moment.worker = FakeSessionNode::kTrainee;
        moment.tube.emplace();
        return moment;
    }
};

} // namespace

/// What a trainee's program tells the session of its registration.
class TestStandingReport : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void tellsOnceAndEveryChange()
    {
        Trainee trainee;
        trainee.report.tell(kGood);
        QVERIFY(trainee.known() == kGood);
        trainee.report.tell(kGood);
        QCOMPARE(trainee.node.proposed, 1);
        trainee.report.tell(kNotGood);
        QVERIFY(trainee.known() == kNotGood);
        trainee.report.tell(kGood);
        QCOMPARE(trainee.node.proposed, 3);
    }

    void tellsAgainAfterComingInAgain()
    {
        Trainee trainee;
        trainee.report.tell(kGood);
        trainee.node.decide(fact::ParticipantJoined{{}, Role::Trainee, "Tom"});
        QVERIFY(!trainee.known());
        trainee.report.tell(kGood);
        QVERIFY(!trainee.known()); // it was said less than a second ago
        trainee.node.advance(milliseconds{1000});
        trainee.report.tell(kGood);
        QVERIFY(trainee.known() == kGood);
    }

    /// What was said of the registration does not hold any more; where nothing was, nothing is.
    void tellsThatThereIsNoTrackerAnyMore()
    {
        constexpr RegistrationStanding none{RegistrationState::NoTracker, StaleReason::None, {}};
        Trainee trainee;
        trainee.report.tell(std::nullopt);
        QCOMPARE(trainee.node.proposed, 0);
        trainee.report.tell(kNotGood);
        trainee.report.tell(std::nullopt);
        trainee.report.tell(std::nullopt);
        QVERIFY(trainee.known() == none);
        QCOMPARE(trainee.node.proposed, 2);
        QCOMPARE(standingText(none), QStringLiteral("–"));
        QVERIFY(standingNotice(none).isEmpty());
        trainee.report.tell(kGood);
        QVERIFY(trainee.known() == kGood);
    }

    /// From the judgement of a site to the trainee's window, to the session, as bytes to other
    /// programs, and to the console.
    void eachCauseIsInBothWindows_data()
    {
        QTest::addColumn<RegistrationStanding>("standing");
        using State = RegistrationState;
        using Why = StaleReason;
        const auto row = [](const char* name, State state, Why why, double error_mm = 0.0) {
            QTest::newRow(name) << RegistrationStanding{state, why, millimetres(error_mm)};
        };
        row("missing", State::Missing, Why::None);
        row("not verified", State::Unverified, Why::None, 2.0);
        row("fitted since it was verified", State::Unverified, Why::Fit, 2.0);
        row("moved since it was verified", State::Unverified, Why::Manikin);
        row("judged not good", State::NotGood, Why::None, 4.2);
        row("tracker", State::Stale, Why::Tracker);
        row("stylus", State::Stale, Why::Stylus);
        row("landmarks", State::Stale, Why::Landmarks);
        row("manikin", State::Stale, Why::Manikin);
        row("touches", State::Stale, Why::Touches);
        row("fit", State::Stale, Why::Fit);
        row("patient", State::Stale, Why::Patient);
        row("registering", State::Stale, Why::Registering);
        row("age", State::Stale, Why::Age);
        row("drift", State::Stale, Why::Drift, 8.0);
    }
    void eachCauseIsInBothWindows()
    {
        QFETCH(const RegistrationStanding, standing);
        Trainee trainee;
        const StationMoment moment = trainee.begin();
        const QString sentence = standingNotice(standing);
        QVERIFY(!sentence.isEmpty());
        QCOMPARE(stationNotice(trainee.node, moment, ViewOutput::Screen, standing), sentence);
        trainee.report.tell(standing);
        QVERIFY(trainee.known() == standing);

        const Proposal proposed{
            {}, FakeSessionNode::kTrainee, kNoStation, fact::RegistrationStated{standing}};
        const auto read = fromRecord(toRecord(proposed));
        QVERIFY(read);
        const auto& told = std::get<fact::RegistrationStated>(read->body).standing;
        QVERIFY(told.state == standing.state && told.reason == standing.reason);
        QVERIFY(std::abs(told.error.si - standing.error.si) < 1e-6);

        trainee.node.becomes(FakeSessionNode::kInstructor);
        SessionModel session{trainee.node};
        const ParticipantsModel console{session};
        const QModelIndex cell = console.index(1, ParticipantsModel::Registration);
        QCOMPARE(console.data(cell, Qt::DisplayRole).toString(), standingText(standing));
        QVERIFY(console.data(cell, Qt::ToolTipRole).toString().contains(sentence.left(20)));
    }

    void waitsWhileTheHostIsAway()
    {
        Trainee trainee;
        trainee.node.hostGoesAway();
        trainee.report.tell(kGood);
        trainee.node.advance(milliseconds{5000});
        trainee.report.tell(kGood);
        trainee.report.tell(kNotGood);
        QCOMPARE(trainee.node.proposed, 1);
        trainee.node.hostComesBack();
        trainee.report.tell(kNotGood);
        QVERIFY(trainee.known() == kNotGood);
    }

    /// What is drawn wrongly at a trainee is to be known of whoever is there.
    void isToldAlsoByWhoIsMuted()
    {
        Trainee trainee;
        trainee.report.tell(kGood);
        trainee.node.decide(fact::ParticipantMuted{FakeSessionNode::kTrainee, true});
        trainee.report.tell(kNotGood);
        QVERIFY(trainee.known() == kNotGood);
    }

    void saysNothingWhileItIsNobody()
    {
        Trainee trainee;
        trainee.node.becomes(kNobody);
        trainee.report.tell(kGood);
        QCOMPARE(trainee.node.proposed, 0);
        trainee.node.becomes(FakeSessionNode::kTrainee);
        trainee.report.tell(kGood);
        QVERIFY(trainee.known() == kGood);
    }

    /// At once in the trainee's own window, whatever the host has of it.
    void isInTheNoticeOfItsOwnWindow()
    {
        Trainee trainee;
        StationMoment moment = trainee.begin();
        const auto notice = [&](const std::optional<RegistrationStanding>& standing) {
            return stationNotice(trainee.node, moment, ViewOutput::Screen, standing);
        };
        QCOMPARE(notice(kNotGood), standingNotice(kNotGood));
        QVERIFY(notice(kNotGood).contains(QStringLiteral("4.2\u00a0mm")));
        QVERIFY(notice(kGood).isEmpty());
        QVERIFY(notice(std::nullopt).isEmpty());
        moment.tube.reset();
        QCOMPARE(notice(kNotGood),
                 QStringLiteral("Tube out of the tracker's view\n") + standingNotice(kNotGood));
    }
};

CARINA_TEST(TestStandingReport)

} // namespace carina::standing_report_test

#include "tst_standing_report.moc"
