#include "engine/tracking/igtl/igtl_client.h"

#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/support/test_class.h"

namespace carina::igtl_client_test
{
namespace
{

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::kQuarterTurn;
using test::messageOf;
using test::streamOf;

const LocalTime kStart{seconds{100}};
constexpr std::uint64_t kSecond = std::uint64_t{1} << 32U;

IgtlClient started(IgtlPoses poses = IgtlPoses::Transform)
{
    IgtlClient client{{{"TubeToTracker", "Jaw"}, poses, 50}};
    client.start(kStart);
    return client;
}

void send(IgtlClient& client, const IgtlMessage& message, LocalTime now)
{
    client.take(encodeIgtl(message), now);
}

} // namespace

class IgtlClientTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    /// A server of version 1 cannot lose its place behind it.
    void beginsWithAQuestionWithoutABody()
    {
        IgtlClient client = started();
        const auto bytes = client.advance(kStart);
        QCOMPARE(bytes.size(), IgtlHeader::kBytes);
        const auto stream = streamOf(bytes);
        QCOMPARE(stream.messages[0].version, std::uint16_t{2});
        QCOMPARE(typeOf(stream.messages[0].content), std::string{"GET_STATUS"});
        QVERIFY(client.farewell().empty());
    }

    void asksForTrackingDataWhereItIsToldTo()
    {
        IgtlClient client = started(IgtlPoses::Qtdata);
        const auto asked = streamOf(client.advance(kStart));
        const auto& start = std::get<IgtlStart>(asked.messages.at(1).content);
        QVERIFY(start.asksQuaternions);
        QCOMPARE(start.interval_ms, 20);
        QCOMPARE(typeOf(streamOf(client.farewell()).messages.at(0).content),
                 std::string{"STP_QTDATA"});
    }

    void takesPosesFromEveryKindOfMessage()
    {
        const IgtlQuaternionTracked jaw{"Jaw", 1, {10, -20, 30}, {0, 0, 0.70711F, 0.70711F}};
        for (const IgtlContent& content : std::initializer_list<IgtlContent>{
                 IgtlTransform{kQuarterTurn}, IgtlPosition{jaw.p, jaw.q, 4},
                 IgtlTrackingData{{{"Other", 1, kQuarterTurn}, {"Jaw", 1, kQuarterTurn}}},
                 IgtlQuaternionTrackingData{{jaw}}}) {
            IgtlClient client = started();
            send(client, messageOf(content, "Jaw"), kStart + milliseconds{5});
            const auto sights = client.takeSights();
            QCOMPARE(sights.size(), std::size_t{1});
            QCOMPARE(sights[0].tool, std::size_t{1});
            QVERIFY(sights[0].exposed == kStart + milliseconds{5});
            QVERIFY((sights[0].X_TO->translation() - Vec3{0.01, -0.02, 0.03}).norm() < 1e-7);
        }
    }

    void doesNotSeeWhatTheServerDoesNotSee()
    {
        IgtlClient client = started();
        IgtlMessage unseen = messageOf(IgtlTransform{kQuarterTurn}, "Jaw");
        unseen.version = 2;
        unseen.metadata = {{"TransformStatus", 3, "OUT_OF_VIEW"}};
        send(client, unseen, kStart);
        send(client, messageOf(IgtlTransform{igtlMatrix(RigidTransform{})}, "Jaw"), kStart);
        unseen.metadata[0].value = "OK";
        send(client, unseen, kStart);
        const auto sights = client.takeSights();
        QCOMPARE(sights.size(), std::size_t{3});
        QVERIFY(!sights[0].X_TO && !sights[1].X_TO && sights[2].X_TO);
    }

    void usesTheServersTime()
    {
        IgtlClient client = started();
        IgtlMessage message = messageOf(IgtlTransform{kQuarterTurn}, "Jaw");
        message.stamp = 1'700'000'000 * kSecond;
        send(client, message, kStart); // at once
        message.stamp += kSecond / 4;
        send(client, message, kStart + milliseconds{300}); // 50 ms later than that
        const auto sights = client.takeSights();
        QVERIFY(sights.at(1).exposed == kStart + milliseconds{250});
    }

    void passesAPoseThatIsSentAgainOnOnce()
    {
        IgtlClient client = started();
        IgtlMessage message = messageOf(IgtlTransform{kQuarterTurn}, "Jaw");
        message.stamp = kSecond;
        send(client, message, kStart);
        send(client, message, kStart + milliseconds{20});
        QCOMPARE(client.takeSights().size(), std::size_t{1});
        std::get<IgtlTransform>(message.content).matrix[9] = 11; // though the time stands still
        send(client, message, kStart + milliseconds{40});
        const auto sights = client.takeSights();
        QCOMPARE(sights.size(), std::size_t{1});
        QVERIFY(sights[0].exposed == kStart + milliseconds{40});
        message.stamp = 0; // no time: each message counts
        send(client, message, kStart + milliseconds{60});
        send(client, message, kStart + milliseconds{80});
        QCOMPARE(client.takeSights().size(), std::size_t{2});
    }

    /// A server that goes on with the last pose of what it does not see any more.
    void losesAToolOfWhichTheSameComesAgainAndAgain()
    {
        IgtlClient client = started();
        IgtlMessage message = messageOf(IgtlTransform{kQuarterTurn}, "Jaw");
        message.stamp = kSecond;
        for (int i = 0; i < 100; ++i) {
            send(client, message, kStart + i * milliseconds{20});
            static_cast<void>(client.advance(kStart + i * milliseconds{20}));
        }
        const auto sights = client.takeSights();
        QCOMPARE(sights.size(), std::size_t{2});
        QVERIFY(sights[0].X_TO && !sights[1].X_TO);
    }

    void seesByTheStatusThoughTheTimeStandsStill()
    {
        IgtlClient client = started();
        IgtlMessage message = messageOf(IgtlTransform{kQuarterTurn}, "Jaw");
        message.version = 2;
        message.stamp = kSecond;
        message.metadata = {{"TransformStatus", 3, "OK"}};
        send(client, message, kStart);
        message.metadata[0].value = "OUT_OF_VIEW";
        send(client, message, kStart + milliseconds{20});
        const auto sights = client.takeSights();
        QCOMPARE(sights.size(), std::size_t{2});
        QVERIFY(sights[0].X_TO && !sights[1].X_TO);
    }

    void losesAToolThatDoesNotComeAnyMore()
    {
        IgtlClient client = started();
        send(client, messageOf(IgtlTransform{kQuarterTurn}, "Jaw"), kStart);
        static_cast<void>(client.advance(kStart));
        QVERIFY(client.nextWake() == kStart + milliseconds{500});
        static_cast<void>(client.advance(kStart + milliseconds{499}));
        QCOMPARE(client.takeSights().size(), std::size_t{1});
        static_cast<void>(client.advance(kStart + milliseconds{500}));
        const auto sights = client.takeSights();
        QCOMPARE(sights.size(), std::size_t{1});
        QVERIFY(!sights[0].X_TO);
        static_cast<void>(client.advance(kStart + milliseconds{900}));
        QVERIFY(client.takeSights().empty());
    }

    void asksAServerThatIsSilent()
    {
        IgtlClient client = started();
        static_cast<void>(client.advance(kStart));
        QVERIFY(client.nextWake() == kStart + seconds{2});
        QVERIFY(client.advance(kStart + milliseconds{1999}).empty());
        const auto asked = streamOf(client.advance(kStart + seconds{2}));
        QCOMPARE(typeOf(asked.messages.at(0).content), std::string{"GET_STATUS"});
        QCOMPARE(asked.messages[0].version, std::uint16_t{1});
        QVERIFY(client.trouble().find("silent") != std::string::npos);
        QVERIFY(client.nextWake() == kStart + seconds{4});
    }

    void namesWhatIsMissingAndWhatComesInstead()
    {
        IgtlClient client = started();
        QCOMPARE(client.trouble(), std::string{});
        for (int i = 0; i <= 20; ++i) {
            const LocalTime now = kStart + i * milliseconds{100};
            send(client, messageOf(IgtlTransform{kQuarterTurn}, "Jaw"), now);
            send(client, messageOf(IgtlTransform{kQuarterTurn}, "Probe\x1B"), now);
        }
        QCOMPARE(client.trouble(), std::string{"it does not send TubeToTracker, but Probe?"});
    }

    void saysWhyAPoseIsRefused()
    {
        IgtlClient client = started();
        IgtlMatrix scaled = kQuarterTurn;
        scaled[0] = 2;
        send(client, messageOf(IgtlTransform{scaled}, "Jaw"), kStart);
        QVERIFY(client.takeSights().empty());
        QVERIFY(client.trouble().starts_with("Jaw: "));
    }

    void noticesWhatIsNotOpenIgtLink()
    {
        IgtlClient client = started();
        const std::string text(100, 'x');
        client.take(std::as_bytes(std::span{text}), kStart);
        QVERIFY(client.isLost());
        QVERIFY(client.trouble().find("OpenIGTLink") != std::string::npos);
        client.start(kStart + seconds{1});
        QVERIFY(!client.isLost());
    }
};

CARINA_TEST(IgtlClientTest)

} // namespace carina::igtl_client_test

#include "tst_igtl_client.moc"
