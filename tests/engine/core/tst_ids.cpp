#include "engine/core/ids.h"
#include "tests/support/test_class.h"

#include <type_traits>
#include <unordered_set>

namespace carina::ids_test
{

class IdsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void comparesByNumber()
    {
        QVERIFY((StationId{2} == StationId{2}));
        QVERIFY((StationId{2} != StationId{3}));
        QVERIFY((FactNumber{2} < FactNumber{10}));
        QCOMPARE(ObjectId{}.value, std::uint16_t{0});
    }

    void isNotMistakenForAnotherKind()
    {
        static_assert(!std::is_convertible_v<StationId, ParticipantId>);
        static_assert(!std::is_convertible_v<std::uint16_t, StationId>);
    }

    void isAKeyOfHashTables()
    {
        const std::unordered_set<ProposalId> ids{{7}, {8}, {7}};
        QCOMPARE(ids.size(), std::size_t{2});
        QVERIFY(ids.contains(ProposalId{8}));
        QVERIFY(!ids.contains(ProposalId{9}));
    }
};

CARINA_TEST(IdsTest)

} // namespace carina::ids_test

#include "tst_ids.moc"
