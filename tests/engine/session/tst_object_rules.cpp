#include "engine/session/participant_limits.h"
#include "tests/engine/session/facts/judging.h"
#include "tests/support/test_class.h"

namespace carina::test::object_rules_test
{
namespace
{

constexpr StationId kSecondStation{1};

fact::ParticipantJoined hostComesIn() { return {kSampleHost, Role::Instructor, "Console"}; }

/// A session whose proposals are judged, and entered where they are fine.
struct Course {
    SessionAuthority authority;
    std::uint64_t proposals = 5000;

    explicit Course(const LogWriter& log) : authority{log.log()} {}

    QByteArray by(ParticipantId author, const FactBody& body, StationId station = kSampleStation)
    {
        const Result<Fact> fact =
            authority.judge({ProposalId{++proposals}, author, station, body}, kNow, kNear);
        if (fact)
            authority.commit(*fact);
        return verdict(fact);
    }
    QByteArray shares(ParticipantId who, const std::string& name,
                      ObjectKind kind = ObjectKind::Stylus)
    {
        return by(who, fact::ObjectShared{{}, who, kind, name});
    }
    [[nodiscard]] SharedObject newest() const
    {
        return authority.state().objects().rbegin()->second;
    }
    QByteArray handsOver(ParticipantId who, const SharedObject& object, ParticipantId to)
    {
        return by(who, fact::ObjectHandedOver{object.id, to, object.epoch});
    }
};

LogWriter withHost()
{
    LogWriter writer = sampleSession();
    writer.add(kNow, hostComesIn());
    writer.add(kNow, fact::StationAdded{"Station 2"}, kSecondStation);
    return writer;
}

/// Nine more trainees, each with eight objects: more than an instructor may own.
constexpr std::uint16_t kCrowd = 9;

LogWriter withCrowd()
{
    LogWriter writer = withHost();
    for (std::uint16_t i = 0; i < kCrowd; ++i) {
        const ParticipantId who{static_cast<std::uint16_t>(50 + i)};
        writer.add(kNow, fact::ParticipantJoined{who, Role::Trainee, "n" + std::to_string(i)});
        for (std::uint16_t j = 0; j < mostObjectsOf(Role::Trainee); ++j)
            writer.add(kNow, fact::ObjectShared{ObjectId{static_cast<std::uint16_t>(
                                                    400 + mostObjectsOf(Role::Trainee) * i + j)},
                                                who, ObjectKind(j % 4), "o" + std::to_string(j)});
    }
    return writer;
}

std::vector<ObjectId> crowdsObjects(const Course& course)
{
    std::vector<ObjectId> objects;
    for (const auto& [id, object] : course.authority.state().objects())
        if (object.sharer.value >= 50 && object.sharer.value < 50 + kCrowd)
            objects.push_back(id);
    return objects;
}

} // namespace

class TestObjectRules : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// Sharing and handing over in turn shared as many objects as one liked.
    void givingAwayMakesNoRoomForMore()
    {
        Course course{withHost()};
        std::size_t objects = 0;
        for (int i = 0; i < 40; ++i) {
            if (course.shares(kSampleOtherTrainee, "object " + std::to_string(i), ObjectKind(i % 4))
                != "fine")
                continue;
            ++objects;
            QCOMPARE(course.handsOver(kSampleOtherTrainee, course.newest(), kSampleHost),
                     QByteArray{"fine"});
        }
        QCOMPARE(objects, mostObjectsOf(Role::Trainee));
    }

    /// The host and an instructor have 64 objects at most, a trainee two of a kind.
    void nobodyIsGivenMoreThanTheyMayHave()
    {
        LogWriter writer = withHost();
        for (std::size_t i = 0; i < mostObjectsOf(Role::Instructor); ++i)
            for (const auto& [who, first] :
                 {std::pair{kSampleHost, 100}, std::pair{kSampleInstructor, 200}})
                writer.add(kNow, fact::ObjectShared{ObjectId{std::uint16_t(first + i)}, who,
                                                    ObjectKind::Jaw, "jaw " + std::to_string(i)});
        for (const int id : {300, 301})
            writer.add(kNow, fact::ObjectShared{ObjectId{std::uint16_t(id)}, kSampleOtherTrainee,
                                                ObjectKind::Tube, "spare " + std::to_string(id)});
        Course course{writer};
        const SharedObject tube = course.authority.state().objects().at(kSampleTube);
        for (const ParticipantId full : {kSampleHost, kSampleInstructor})
            QCOMPARE(course.handsOver(kSampleTrainee, tube, full), QByteArray{"not permitted"});
        QCOMPARE(course.handsOver(kSampleHost, tube, kSampleOtherTrainee),
                 QByteArray{"not permitted"});
    }

    /// Eight names handed eight objects each to an instructor, who then could take nothing back.
    void nobodyFillsTheHandsOfAnInstructor_data()
    {
        QTest::addColumn<bool>("isHost");
        QTest::newRow("the host") << true;
        QTest::newRow("another") << false;
    }
    void nobodyFillsTheHandsOfAnInstructor()
    {
        QFETCH(const bool, isHost);
        const ParticipantId instructor = isHost ? kSampleHost : kSampleInstructor;
        Course course{withCrowd()};
        std::size_t given = 0;
        for (const ObjectId each : crowdsObjects(course)) {
            const SharedObject object = course.authority.state().objects().at(each);
            given += course.handsOver(object.owner, object, instructor) == "fine" ? 1 : 0;
        }
        QCOMPARE(given, kMostGiven);
        // The instructor takes what there is, and is given what they asked for.
        for (const ObjectId each : crowdsObjects(course)) {
            const SharedObject object = course.authority.state().objects().at(each);
            if (object.owner != instructor)
                QCOMPARE(course.handsOver(instructor, object, instructor), QByteArray{"fine"});
        }
        const SharedObject tube = course.authority.state().objects().at(kSampleTube);
        QCOMPARE(course.handsOver(kSampleTrainee, tube, instructor), QByteArray{"not permitted"});
        QCOMPARE(course.by(instructor, fact::ObjectWanted{kSampleTube}), QByteArray{"fine"});
        QCOMPARE(course.handsOver(kSampleTrainee, tube, instructor), QByteArray{"fine"});
    }

    /// One who got a tube unasked worked with that one instead of with their own.
    void aTraineeGivesToAnInstructorOrToWhoAsked()
    {
        Course course{withHost()};
        const SharedObject tube = course.authority.state().objects().at(kSampleTube);
        QCOMPARE(course.handsOver(kSampleTrainee, tube, kSampleOtherTrainee),
                 QByteArray{"not permitted"});
        QCOMPARE(course.by(kSampleOtherTrainee, fact::ObjectWanted{kSampleTube}),
                 QByteArray{"fine"});
        Course unasked{withHost()};
        QCOMPARE(unasked.handsOver(kSampleTrainee, tube, kSampleInstructor), QByteArray{"fine"});
        Course byInstructor{withHost()};
        QCOMPARE(byInstructor.handsOver(kSampleInstructor, tube, kSampleOtherTrainee),
                 QByteArray{"fine"});
        QCOMPARE(course.handsOver(kSampleTrainee, tube, kSampleOtherTrainee), QByteArray{"fine"});
    }

    void objectsHaveNamesThatCanBeRead_data()
    {
        QTest::addColumn<QByteArray>("name");
        QTest::addColumn<QByteArray>("expected");
        const auto row = [](const char* title, const char* name, const char* expected) {
            QTest::newRow(title) << QByteArray{name} << QByteArray{expected};
        };
        row("plain", "Tube 7.0", "fine");
        row("of another language", "Стилет", "fine");
        row("control", "Tube\x1b[2J", "name unclear");
        row("line", "Tube\nTom", "name unclear");
        row("order of writing", "Tube\u202eebut", "name unclear");
        row("invisible",
            "Tu\u200b"
            "be",
            "name unclear");
        row("blank", " ", "name unclear");
        row("empty", "", "name unclear");
    }

    void objectsHaveNamesThatCanBeRead()
    {
        QFETCH(const QByteArray, name);
        QFETCH(const QByteArray, expected);
        Course course{withHost()};
        QCOMPARE(course.shares(kSampleTrainee, name.toStdString()), expected);
        QCOMPARE(course.shares(kSampleInstructor, name.toStdString()), expected);
    }
};

CARINA_TEST(TestObjectRules)

} // namespace carina::test::object_rules_test

#include "tst_object_rules.moc"
