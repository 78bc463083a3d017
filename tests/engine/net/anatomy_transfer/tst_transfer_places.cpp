#include "engine/net/anatomy_transfer/transfer_places.h"
#include "tests/support/test_class.h"

#include <vector>

namespace carina::transfer_places_test
{
namespace
{

using namespace std::chrono_literals;

SourcePrefix address(std::size_t number)
{
    SourcePrefix prefix{};
    prefix[0] = static_cast<std::uint8_t>(number);
    return prefix;
}

TransferPlace place(std::size_t participant, std::size_t from, Duration held = 1s,
                    double bytesPerSecond = 1e5)
{
    return {{Role::Trainee, ParticipantId{static_cast<std::uint16_t>(participant)}},
            address(from),
            held,
            bytesPerSecond};
}

TransferPlace placeByCode(std::size_t from)
{
    TransferPlace by = place(0, from);
    by.who.participant.reset();
    return by;
}

/// As many as an address may have, each of another participant.
void crowd(std::vector<TransferPlace>& places, std::size_t from, Duration held = 1s)
{
    for (std::size_t i = 0; i < kMostTransfersOfAddress; ++i)
        places.push_back(place(1 + places.size(), from, held));
}

} // namespace

class TestTransferPlaces : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isFreeUntilAllAreTaken()
    {
        std::vector<TransferPlace> places;
        for (std::size_t i = 0; i < kMostTransfers; ++i) {
            const auto verdict = placeFor(place(1 + i, 1 + i), places);
            QVERIFY(verdict.isAdmitted && !verdict.ended);
            places.push_back(place(1 + i, 1 + i));
        }
        QVERIFY(!placeFor(place(99, 99), places).isAdmitted); // all the same, and none for long
    }

    void tokenHasTwo()
    {
        const std::vector<TransferPlace> places{place(1, 1, 1h), place(1, 2, 1h)};
        QVERIFY(!placeFor(place(1, 3), places).isAdmitted);
        QVERIFY(placeFor(place(2, 1), places).isAdmitted);
    }

    void codeHasAsManyAsAnAddress()
    {
        std::vector<TransferPlace> places(kMostTransfersOfAddress, placeByCode(1));
        QVERIFY(!placeFor(placeByCode(1), places).isAdmitted);
        QVERIFY(placeFor(placeByCode(2), places).isAdmitted);
        places.pop_back();
        QVERIFY(placeFor(placeByCode(1), places).isAdmitted);
    }

    void slowestOfTheAddressThatHasMostMakesRoom()
    {
        std::vector<TransferPlace> places;
        for (std::size_t from = 1; from <= 4; ++from)
            crowd(places, from);
        places[3].bytesPerSecond = 10.0;
        places.erase(places.end() - 1); // address 4 has one less
        places.push_back(place(90, 5, 1h, 1.0));
        const auto verdict = placeFor(place(99, 6), places);
        QVERIFY(verdict.isAdmitted);
        QCOMPARE(verdict.ended, std::optional<std::size_t>{3}); // not the slowest of all
    }

    void holderThatHasMostOfAnAddressMakesRoom()
    {
        std::vector<TransferPlace> places;
        crowd(places, 1);
        places[5] = place(1, 1, 1s, 10.0); // participant 1 has two
        places[7].bytesPerSecond = 1.0;
        const auto verdict = placeFor(place(99, 1), places);
        QVERIFY(verdict.isAdmitted);
        QCOMPARE(verdict.ended, std::optional<std::size_t>{5});
        // Others who have one each have no better right than one who comes: they wait.
        places[5] = place(50, 1, 1s, 10.0);
        QVERIFY(!placeFor(place(99, 1), places).isAdmitted);
    }

    void slowestWhoseTurnIsOverMakesRoom()
    {
        std::vector<TransferPlace> places;
        crowd(places, 1, kTransferTurn - 1ns);
        QVERIFY(!placeFor(place(99, 1), places).isAdmitted);
        places[2].held = kTransferTurn;
        places[6].held = kTransferTurn;
        places[6].bytesPerSecond = 9e4;
        const auto verdict = placeFor(place(99, 1), places);
        QVERIFY(verdict.isAdmitted);
        QCOMPARE(verdict.ended, std::optional<std::size_t>{6});
    }
};

CARINA_TEST(TestTransferPlaces)

} // namespace carina::transfer_places_test

#include "tst_transfer_places.moc"
