#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

namespace carina::node_stations_test
{

constexpr StationId kRoom{1};

/// Programs at several stations of one session.
class TestNodeStations : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void programsComeToTheStationTheyWant()
    {
        Course course;
        const auto anna = course.comes("Anna", "room 5");
        const auto ben = course.comes("Ben", "");
        QTRY_COMPARE_WITH_TIMEOUT(ownStation(*anna), kRoom, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(ownStation(*ben), kStation, kPatience_ms);
        QCOMPARE(ownStation(*course.instructor), kStation);
    }

    void programsAreToldWhichStationsThereAre()
    {
        Course course;
        const auto anna = course.comes("Anna", "Room 6");
        QTRY_VERIFY_WITH_TIMEOUT(anna->refusal(), kPatience_ms);
        QCOMPARE(anna->refusal()->code, Errc::StationUnknown);
        QCOMPARE(anna->refusal()->detail, std::string{"open: Station 1, Room 5"});
        QCOMPARE(ownStation(*anna), kNoStation);
        QCOMPARE(course.instructor->state()->participants().size(), std::size_t{1});
    }

    void longNameOfAStationIsRefusedAtOnce()
    {
        Course course;
        JoinSettings settings = joinSettings(*course.instructor, "Anna");
        settings.station = std::string(65, 'x');
        const auto joined = SessionNode::join(settings);
        QVERIFY(!joined);
        QCOMPARE(joined.error().code, Errc::OutOfRange);
    }

    void whoWasMovedStaysThere()
    {
        Course course;
        const auto anna = course.comes("Anna", "Station 1");
        QTRY_COMPARE_WITH_TIMEOUT(ownStation(*anna), kStation, kPatience_ms);
        course.instructor->propose(kRoom, fact::ParticipantMoved{anna->self()});
        QTRY_COMPARE_WITH_TIMEOUT(ownStation(*anna), kRoom, kPatience_ms);
        // The way to the host is lost and found again, and no wish is repeated.
        const std::uint16_t port = course.instructor->port();
        course.instructor.reset();
        QTRY_VERIFY_WITH_TIMEOUT(linkOf(*anna) != LinkState::Connected, kPatience_ms);
        course.instructor = host(course.disk, port);
        QTRY_COMPARE_WITH_TIMEOUT(linkOf(*anna), LinkState::Connected, kPatience_ms);
        QTRY_COMPARE_WITH_TIMEOUT(anna->state()->lastApplied(),
                                  course.instructor->state()->lastApplied(), kPatience_ms);
        QCOMPARE(ownStation(*anna), kRoom);
    }

    void toolsGoAlongAndAreSeenThere()
    {
        Course course;
        const auto anna = course.comes("Anna", "");
        anna->publish(ObjectKind::Tube, "Tube", stillTube(*anna));
        const auto isSeen = [&] {
            const auto tube = onlyObject(*course.instructor);
            return tube && tube->newest();
        };
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(), kPatience_ms);
        const auto before = onlyObject(*course.instructor);
        course.instructor->propose(kRoom, fact::ParticipantMoved{anna->self()});
        QTRY_VERIFY_WITH_TIMEOUT(onlyObject(*course.instructor) != before, kPatience_ms);
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(), kPatience_ms);
        const auto state = course.instructor->state();
        QCOMPARE(state->objects().size(), std::size_t{1});
        QCOMPARE(state->objects().begin()->second.station, kRoom);
        QVERIFY(onlyObject(*course.instructor)->newest()->time
                > *state->participants().at(anna->self()).moved);
    }

private:
    /// A session with a second station.
    struct Course {
        MemoryDisk disk;
        std::unique_ptr<SessionNode> instructor = host(disk);

        Course() { instructor->propose(kNoStation, fact::StationAdded{"Room 5"}); }
        [[nodiscard]] std::unique_ptr<SessionNode> comes(const char* name,
                                                         const char* station) const
        {
            JoinSettings settings = joinSettings(*instructor, name);
            settings.station = station;
            return join(settings);
        }
    };
};

CARINA_TEST(TestNodeStations)

} // namespace carina::node_stations_test

#include "tst_node_stations.moc"
