#include "tests/engine/session/facts/sample_session.h"
#include "tests/support/test_class.h"

namespace carina::test::object_wishes_test
{

/// Who asks for a shared object, and until when.
class TestObjectWishes : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void standInTheirOrderUntilTheyAreMet();
};

void TestObjectWishes::standInTheirOrderUntilTheyAreMet()
{
    LogWriter writer = sampleSession();
    const auto asks = [&](ParticipantId who, bool wanted = true, ObjectId object = kSampleTube) {
        writer.add(atSeconds(1.0), fact::ObjectWanted{object, wanted}, kSampleStation, who);
    };
    using Asking = std::vector<ParticipantId>;
    const auto asking = [&] {
        return SessionAuthority{writer.log()}.state().objects().at(kSampleTube).wantedBy;
    };
    QVERIFY(asking().empty());
    asks(kSampleTrainee); // has it
    asks(kSampleInstructor, true, ObjectId{9});
    QVERIFY(asking().empty());
    asks(kSampleOtherTrainee);
    asks(kSampleInstructor);
    asks(kSampleOtherTrainee); // once is enough
    QVERIFY((asking() == Asking{kSampleOtherTrainee, kSampleInstructor}));
    writer.add(atSeconds(2.0), fact::ObjectHandedOver{kSampleTube, kSampleInstructor, 1});
    QVERIFY((asking() == Asking{kSampleOtherTrainee}));
    asks(kSampleTrainee);
    asks(kSampleTrainee, false);
    QVERIFY((asking() == Asking{kSampleOtherTrainee}));
    writer.add(atSeconds(3.0), fact::ParticipantLeft{kSampleOtherTrainee});
    QVERIFY(asking().empty());
}

CARINA_TEST(TestObjectWishes)

} // namespace carina::test::object_wishes_test

#include "tst_object_wishes.moc"
