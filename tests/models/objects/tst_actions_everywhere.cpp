#include "models/objects/liftables.h"
#include "models/objects/object_action_model.h"
#include "models/patient/shared_patient.h"
#include "tests/engine/net/node/nodes.h"
#include "tests/support/test_class.h"

namespace carina::actions_everywhere_test
{

/// Models over real nodes, as the programs have them.
class TestActionsEverywhere : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void areTheSameForALateJoinerAndAfterARestart();
    void whatIsPutBackStaysInItsPlaceAfterARestart();
};

namespace
{

/// A program with its models.
struct Console {
    std::unique_ptr<SessionNode> node;
    SessionModel session{*node};
    SharedObjectModel object{session, kStation};
    ObjectActionModel model{object};

    [[nodiscard]] QStringList told() const
    {
        QString owner = object.ownerText();
        owner.remove(0, 2); // ● or ◆
        return {model.motionText(), model.placeText(), object.wishText(), owner};
    }
};

} // namespace

void TestActionsEverywhere::areTheSameForALateJoinerAndAfterARestart()
{
    MemoryDisk disk;
    auto host = std::make_unique<Console>(carina::host(disk));
    const std::uint16_t port = host->node->port();
    sharePatient(*host->node, kStation, "Adult");
    Console anna{join(*host->node, "Anna")};
    QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna.node) && anna.object.chosen(), kPatience_ms);
    host->object.handOver(anna.node->self());
    QTRY_VERIFY_WITH_TIMEOUT(anna.object.isOwn(), kPatience_ms);
    anna.model.setSpeed(180.0);
    anna.model.start();
    QTRY_VERIFY_WITH_TIMEOUT(anna.model.canStop() && !anna.model.isInPlace(), kPatience_ms);
    anna.model.stop();
    QTRY_VERIFY_WITH_TIMEOUT(!anna.model.canStop(), kPatience_ms);

    Console late{join(*host->node, "Ben")};
    const auto agree = [&anna](const Console& other) {
        QStringList expected = anna.told();
        expected.back() = QStringLiteral("Anna");
        return other.told() == expected;
    };
    QTRY_VERIFY_WITH_TIMEOUT(agree(late), kPatience_ms);
    late.object.ask();
    QTRY_COMPARE_WITH_TIMEOUT(anna.object.wishText(), QStringLiteral("Asking for it: Ben"),
                              kPatience_ms);
    QTRY_VERIFY_WITH_TIMEOUT(agree(*host), kPatience_ms);
    host.reset();
    host = std::make_unique<Console>(carina::host(disk, port));
    QTRY_VERIFY_WITH_TIMEOUT(agree(*host), kPatience_ms);
    QVERIFY(!host->model.isInPlace());
    sharePatient(*host->node, kStation, "Adult");
    QCOMPARE(host->object.objects().size(), std::size_t{1});
}

/// What was lifted out is as it was, and once it is put back nothing of its motion comes again.
void TestActionsEverywhere::whatIsPutBackStaysInItsPlaceAfterARestart()
{
    MemoryDisk disk;
    auto host = std::make_unique<Console>(carina::host(disk));
    const std::uint16_t port = host->node->port();
    shareLiftables(*host->node, kStation);
    Console anna{join(*host->node, "Anna")};
    QTRY_VERIFY_WITH_TIMEOUT(isIn(*anna.node) && anna.object.objects().size() > 1, kPatience_ms);
    const ObjectId lungs = anna.object.objects().at(1).id;
    anna.object.choose(lungs);
    anna.object.lift();
    QTRY_VERIFY_WITH_TIMEOUT(anna.object.isOwn(), kPatience_ms);
    anna.model.setSpeed(180.0);
    anna.model.start();
    QTRY_VERIFY_WITH_TIMEOUT(anna.model.canStop() && !anna.model.isInPlace(), kPatience_ms);
    anna.model.stop();
    host->object.choose(lungs);
    QTRY_COMPARE_WITH_TIMEOUT(host->model.placeText(), anna.model.placeText(), kPatience_ms);

    const auto restart = [&] {
        host.reset();
        host = std::make_unique<Console>(carina::host(disk, port));
        host->object.choose(lungs);
    };
    restart();
    QTRY_COMPARE_WITH_TIMEOUT(host->model.placeText(), anna.model.placeText(), kPatience_ms);
    anna.model.putBack();
    const auto isBack = [](const Console& console) {
        return console.object.chosen()->owner == kNobody && console.model.isInPlace();
    };
    QTRY_VERIFY_WITH_TIMEOUT(isBack(anna) && isBack(*host), kPatience_ms);
    restart();
    QVERIFY(isBack(*host));
    host->object.lift();
    QTRY_VERIFY_WITH_TIMEOUT(host->object.isOwn(), kPatience_ms);
    QVERIFY(host->model.isInPlace());
}

CARINA_TEST(TestActionsEverywhere)

} // namespace carina::actions_everywhere_test

#include "tst_actions_everywhere.moc"
