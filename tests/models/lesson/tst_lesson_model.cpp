#include "models/lesson/lesson_model.h"
#include "models/lesson/lesson_words.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"

namespace carina::lesson_model_test
{
namespace
{

using test::FakeSessionNode;

constexpr StationId kStation = FakeSessionNode::kStation;
constexpr ParticipantId kIna = FakeSessionNode::kInstructor;
constexpr ParticipantId kTom = FakeSessionNode::kTrainee;
constexpr StationId kRoom{1};
const RigidTransform kSomewhere = RigidTransform::translation({0.1, -2.0, 0.3});

Lesson cut(double distance)
{
    return {{true, LessonCut::All, {0.0, -1.0, 0.0}, distance}, false, {}};
}

Lesson named()
{
    return {{}, false, {{3, 5, LessonStyle::AsUsual, true, true}, {7, 7, LessonStyle::Hidden}}};
}

struct Desk {
    FakeSessionNode node;
    SessionModel session{node};
    LessonModel model{session, kStation};
    ChangeHistory history;

    Desk() { model.setHistory(history); }
    [[nodiscard]] std::optional<ShownLesson> shown(StationId station = kStation) const
    {
        return node.state()->stations().at(station).lesson;
    }
    /// A second station, and something that is shown to Tom at the first one.
    void teachTom()
    {
        node.addStation("Room 5");
        model.follow(cut(0.01));
        model.setTarget(kTom);
        model.setShowsView(false);
        model.setOn(true);
    }
    /// With their tools.
    void go(StationId station) { node.decideAt(station, fact::ParticipantMoved{kIna}); }
    void wait() { node.advance(LessonModel::kShortestPause); }
};

} // namespace

class TestLessonModel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsNothingUntilItIsSwitchedOn()
    {
        Desk desk;
        desk.model.follow(cut(0.01));
        QVERIFY(!desk.shown() && !desk.model.isOn());
        QVERIFY(desk.model.text().isEmpty());
        desk.model.setOn(true);
        QVERIFY(desk.model.isOn());
        QVERIFY(desk.shown()->by == kIna && desk.shown()->to == kNobody);
        QVERIFY(desk.shown()->lesson.section == cut(0.01).section);
        QVERIFY(desk.shown()->lesson.showsView);
        QCOMPARE(desk.model.text(),
                 QStringLiteral("● Shown to everybody: section, view; your mouse over the picture "
                                "is the pointer"));
        desk.model.setOn(false);
        QVERIFY(!desk.shown() && !desk.model.isOn());
    }

    /// Each picture is a fact: a slider that is dragged is no flood of them.
    void followsItsPictureAtABoundedRate()
    {
        Desk desk;
        desk.model.setOn(true);
        const int before = desk.node.proposed;
        for (int step = 1; step <= 20; ++step)
            desk.model.follow(cut(0.001 * step));
        QCOMPARE(desk.node.proposed, before);
        desk.wait();
        desk.model.follow(cut(0.02));
        QVERIFY(desk.shown()->lesson.section == cut(0.02).section);
        desk.wait();
        desk.model.follow(cut(0.02));
        QCOMPARE(desk.node.proposed, before + 1); // it is shown already
    }

    void isShownToWhomIsChosen()
    {
        Desk desk;
        QCOMPARE(desk.model.targets().size(), std::size_t{3}); // everybody, trainee and observer
        desk.model.setTarget(kTom);
        QVERIFY(desk.history.isEmpty()); // nobody has seen anything
        desk.model.setOn(true);
        QVERIFY(desk.shown()->to == kTom);
        desk.model.setTarget(kNobody);
        QVERIFY(desk.shown()->to == kNobody);
        desk.model.setOn(false);
        desk.model.setTarget(kTom);
        desk.node.decide(fact::ParticipantLeft{kTom});
        QVERIFY(desk.model.target() == kNobody);
    }

    void undoTakesBackWhatIsShownAndToWhom()
    {
        Desk desk;
        desk.model.setOn(true);
        desk.model.setTarget(kTom);
        desk.model.setShowsView(false);
        desk.model.setOn(false);
        QCOMPARE(desk.history.texts(),
                 (QStringList{QStringLiteral("Showing → off"), QStringLiteral("Showing → Tom"),
                              QStringLiteral("Showing, with the view → Tom"),
                              QStringLiteral("Showing, with the view → everybody")}));
        desk.history.undo();
        QVERIFY(desk.shown()->to == kTom && !desk.shown()->lesson.showsView);
        desk.history.undo();
        QVERIFY(desk.shown()->to == kTom && desk.shown()->lesson.showsView);
        desk.history.undo();
        QVERIFY(desk.shown()->to == kNobody);
        desk.history.undo();
        QVERIFY(!desk.shown());
        QVERIFY(desk.history.isEmpty());
    }

    /// Those at a station see on what they saw.
    void losesNothingByAGlanceAtAnotherStation()
    {
        Desk desk;
        desk.teachTom();
        const auto before = desk.shown();
        QVERIFY(before && before->to == kTom);
        desk.model.setStation(kRoom);
        QVERIFY(!desk.model.isOn() && desk.model.target() == kNobody);
        QCOMPARE(desk.model.elsewhereText(),
                 QStringLiteral("● Still shown at Station 1 to Tom: section"));
        desk.wait();
        desk.model.follow(named()); // how the other station is drawn
        desk.model.pointWith(kSomewhere);
        QVERIFY(desk.shown() == before && !desk.shown(kRoom));
        desk.model.setStation(kStation);
        QVERIFY(desk.model.isOn() && desk.model.target() == kTom && !desk.model.showsView());
        QVERIFY(desk.shown() == before);
        QVERIFY(desk.model.elsewhereText().isEmpty());
        desk.wait();
        desk.model.follow(cut(0.02));
        QVERIFY(desk.shown()->lesson.section == cut(0.02).section);
    }

    void keepsItsChoicesWhileNothingIsShown()
    {
        Desk desk;
        desk.node.addStation("Room 5");
        desk.model.setTarget(kTom);
        desk.model.setShowsView(false);
        desk.model.setStation(kRoom);
        desk.model.setShowsView(true);
        desk.model.setStation(kStation);
        QVERIFY(desk.model.target() == kTom && !desk.model.showsView());
        QVERIFY(!desk.shown() && !desk.shown(kRoom));
    }

    /// What a person shows ends where they go away from, as with tools.
    void isShownAgainWhereTheyComeBackTo()
    {
        Desk desk;
        desk.teachTom();
        const auto before = desk.shown();
        desk.model.setStation(kRoom);
        desk.go(kRoom);
        QVERIFY(!desk.shown());
        desk.model.setStation(kStation);
        QVERIFY(desk.shown() == before);
        QVERIFY(ownStation(desk.node) == kStation); // with their view and pointer
    }

    void goesOnWhereItWasSwitchedOnLast()
    {
        Desk desk;
        desk.teachTom();
        desk.model.setStation(kRoom);
        desk.model.setOn(true);
        QVERIFY(!desk.shown());
        QVERIFY(desk.shown(kRoom)->lesson.section == Lesson{}.section); // not that of the first
        QVERIFY(ownStation(desk.node) == kRoom); // with their view and pointer
        const auto before = desk.shown(kRoom);
        desk.model.setStation(kStation);
        QVERIFY(!desk.shown() && !desk.model.isOn());
        QVERIFY(desk.shown(kRoom) == before);
    }

    void staysOffWhereItWasEndedOrHasNoSense_data()
    {
        QTest::addColumn<int>("what");
        QTest::newRow("another instructor ended it") << 0;
        QTest::newRow("another patient lies there") << 1;
        QTest::newRow("who saw it has left") << 2;
        QTest::newRow("somebody else shows something") << 3;
    }
    void staysOffWhereItWasEndedOrHasNoSense()
    {
        QFETCH(const int, what);
        Desk desk;
        desk.teachTom();
        desk.model.setStation(kRoom);
        if (what == 0)
            desk.node.decide(fact::LessonEnded{});
        else
            desk.go(kRoom);
        if (what == 1)
            desk.node.decide(fact::AnatomyChosen{"0f0f", "Another"});
        if (what == 2)
            desk.node.decide(fact::ParticipantLeft{kTom});
        if (what == 3)
            desk.node.decide(fact::LessonShown{kTom, cut(0.03)});
        const auto before = desk.shown();
        const int proposed = desk.node.proposed;
        desk.model.setStation(kStation);
        QVERIFY(!desk.model.isOn() && desk.shown() == before);
        QCOMPARE(desk.node.proposed, proposed);
    }

    void undoReachesWhatIsShownAtAnotherStation()
    {
        Desk desk;
        desk.teachTom();
        const auto before = desk.shown();
        desk.model.setOn(false);
        desk.model.setStation(kRoom);
        QCOMPARE(desk.history.texts().size(), 2);
        desk.history.undo();
        QVERIFY(desk.shown() == before);
        desk.history.undo();
        QVERIFY(!desk.shown());
        desk.model.setStation(kStation);
        QVERIFY(!desk.model.isOn() && desk.model.target() == kTom);
        QVERIFY(!desk.node.refusal());
    }

    /// The instructor's program stopped without a word, and is here again.
    void showsAgainWhatBrokeOff()
    {
        Desk desk;
        QVERIFY(!desk.model.brokenOff());
        desk.model.follow(cut(0.01));
        desk.model.setShowsView(false);
        desk.model.setTarget(kTom);
        desk.model.setOn(true);
        const auto before = desk.shown();
        desk.node.decide(fact::ParticipantJoined{{}, Role::Instructor, "Ina"});
        QVERIFY(!desk.shown() && !desk.model.isOn());
        QVERIFY(desk.model.brokenOff() == before);

        LessonModel again{desk.session, kStation};
        ChangeHistory history;
        again.setHistory(history);
        QVERIFY(again.canShowAgain());
        again.showAgain();
        QVERIFY(desk.shown() == before);
        QVERIFY(again.isOn() && !again.brokenOff() && again.target() == kTom);
        const int proposed = desk.node.proposed;
        QVERIFY(!again.canShowAgain());
        again.showAgain(); // pressed twice
        QCOMPARE(desk.node.proposed, proposed);
        history.undo();
        QVERIFY(!desk.shown());
    }

    void pointsOnlyWhileItIsOn()
    {
        Desk desk;
        const auto pointer = [](const Desk& shown) {
            return shown.model.poses().at(ObjectKind::Pointer, *shown.node.now());
        };
        desk.model.pointWith(kSomewhere);
        QVERIFY(!pointer(desk));
        desk.model.setOn(true);
        desk.model.pointWith(kSomewhere);
        QVERIFY(pointer(desk) && pointer(desk)->X_FO.translation() == kSomewhere.translation());
        QVERIFY(desk.model.text().contains(QStringLiteral("view, pointer;")));
        desk.model.setOn(false);
        QVERIFY(!pointer(desk));
    }

    /// Others have a pointer that rests for as long as it does: its samples do not wait for a hand,
    /// nor for a picture.
    void pointerStaysWhereItRests()
    {
        Desk desk;
        desk.model.setOn(true);
        desk.model.pointWith(kSomewhere);
        const auto shared = std::ranges::find(desk.node.published, ObjectKind::Pointer,
                                              &FakeSessionNode::Published::kind);
        QVERIFY(shared != desk.node.published.end());
        desk.node.advance(std::chrono::seconds{10});
        auto sample = shared->newest();
        QVERIFY(sample && sample->time == *desk.node.now());
        QVERIFY(sample->X_FO.translation() == kSomewhere.translation());
        desk.model.pointWith(std::nullopt); // the mouse leaves the picture
        QVERIFY(!shared->newest());
        desk.model.pointWith(kSomewhere);
        desk.model.setOn(false);
        QVERIFY(!shared->newest());
        desk.model.setOn(true);
        desk.model.pointWith(kSomewhere);
        QVERIFY(shared->newest());
        desk.node.decide(fact::LessonEnded{}); // by another instructor
        QCoreApplication::sendPostedEvents();
        QVERIFY(!shared->newest());
    }

    void saysWhatIsShown()
    {
        QCOMPARE(lessonText({}, false), QStringLiteral("the patient as usual"));
        QCOMPARE(lessonText(cut(0.0), true), QStringLiteral("section, pointer"));
        QCOMPARE(lessonText(named(), false), QStringLiteral("highlights, names, parts hidden"));
    }

    void tellsAboutTheViewWhereItIsFollowed()
    {
        StationMoment moment;
        QVERIFY(lessonNotice(moment, false).isEmpty());
        moment.lesson = ShownLesson{kIna, kNobody, cut(0.0)};
        moment.lesson->lesson.showsView = true;
        QCOMPARE(lessonNotice(moment, false), QStringLiteral("● The instructor shows: section"));
        QCOMPARE(lessonNotice(moment, true),
                 QStringLiteral("● The instructor shows: section, view"));
    }
};

CARINA_TEST(TestLessonModel)

} // namespace carina::lesson_model_test

#include "tst_lesson_model.moc"
