#include "engine/sync/streams/stream_slots.h"
#include "tests/support/test_class.h"

namespace carina::stream_slots_test
{
namespace
{

constexpr StationId kHere{1};
constexpr StationId kThere{2};
const StreamPlace kCrowd{7, kNobody};
const StreamPlace kClass{8, kNobody};

ObjectId object(std::size_t number) { return ObjectId{static_cast<std::uint16_t>(number)}; }

/// Eight objects each, as a trainee may share.
ParticipantId ownerOf(std::size_t number)
{
    return ParticipantId{static_cast<std::uint16_t>(100 + number / 8)};
}

/// So many of the objects from `first` on as get a slot.
std::size_t taken(StreamSlots& all, std::size_t first, std::size_t count, StationId station,
                  const StreamPlace& place)
{
    std::size_t number = 0;
    for (std::size_t i = first; i < first + count; ++i)
        number += all.takes(object(i), station, ownerOf(i), place) ? 1 : 0;
    return number;
}

} // namespace

/// How many objects may be streamed, and whose.
class TestStreamSlots : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void stationHasSoManyAndNoMore()
    {
        StreamSlots all;
        QCOMPARE(taken(all, 1, 200, kHere, kCrowd), StreamSlots::kMostOfStation);
        QCOMPARE(taken(all, 1, 200, kHere, kCrowd), StreamSlots::kMostOfStation); // the same
        QVERIFY(all.takes(object(1), kHere, ownerOf(1), kCrowd));
        QVERIFY(!all.takes(object(200), kHere, ownerOf(200), kCrowd));
    }

    void placeHasSoManyAtAllStations()
    {
        StreamSlots all;
        QCOMPARE(taken(all, 1, 90, kHere, kCrowd) + taken(all, 91, 90, kThere, kCrowd),
                 StreamSlots::kMostOfPlace);
        QCOMPARE(taken(all, 300, 8, kThere, kClass), std::size_t{8});
    }

    /// Who comes first does not keep out those who come later from elsewhere.
    void whoHasFewGetsThoseOfWhoHasMost()
    {
        StreamSlots all;
        QCOMPARE(taken(all, 1, 200, kHere, kCrowd), StreamSlots::kMostOfStation);
        QCOMPARE(taken(all, 300, 16, kHere, kClass), std::size_t{16});
        // The last of the crowd have given way, and cannot take back what others have.
        QCOMPARE(taken(all, 1, 200, kHere, kCrowd), StreamSlots::kMostOfStation - 16);
        QCOMPARE(taken(all, 300, 16, kHere, kClass), std::size_t{16});
    }

    void twoPlacesEndWithAsManyEach()
    {
        StreamSlots all;
        taken(all, 1, 200, kHere, kCrowd);
        for (int turn = 0; turn < 3; ++turn) {
            QCOMPARE(taken(all, 300, 200, kHere, kClass), StreamSlots::kMostOfStation / 2);
            QCOMPARE(taken(all, 1, 200, kHere, kCrowd), StreamSlots::kMostOfStation / 2);
        }
    }

    void slotIsFreeWhenItsOwnerGoesOrChanges()
    {
        StreamSlots all;
        taken(all, 1, 200, kHere, kCrowd);
        all.leave(ownerOf(1)); // of objects 1 to 7
        QCOMPARE(taken(all, 150, 20, kHere, kCrowd), std::size_t{7});
        all.owned(object(8), ownerOf(8)); // as before
        QVERIFY(!all.takes(object(180), kHere, ownerOf(180), kCrowd));
        all.owned(object(8), ownerOf(200));
        all.owned(object(8), ownerOf(200)); // has none any more
        QVERIFY(all.takes(object(180), kHere, ownerOf(180), kCrowd));
        QVERIFY(!all.takes(object(181), kHere, ownerOf(181), kCrowd));
    }

    void objectTakesItsSlotAlongToAnotherStation()
    {
        StreamSlots all;
        QVERIFY(all.takes(object(1), kHere, ownerOf(1), kCrowd));
        QVERIFY(all.takes(object(1), kThere, ownerOf(1), kCrowd));
        QCOMPARE(taken(all, 10, 200, kHere, kClass), StreamSlots::kMostOfStation);
    }
};

CARINA_TEST(TestStreamSlots)

} // namespace carina::stream_slots_test

#include "tst_stream_slots.moc"
