#include "engine/tracking/igtl/igtl_subscriber.h"

#include "engine/tracking/igtl/igtl_pose.h"
#include "tests/engine/tracking/igtl/igtl_samples.h"
#include "tests/support/test_class.h"

namespace carina::igtl_subscriber_test
{
namespace
{

using std::chrono::milliseconds;
using std::chrono::seconds;
using test::messageOf;
using test::streamOf;

const LocalTime kStart{seconds{100}};
const LocalTime kDecided = kStart + milliseconds{300};

IgtlOffer offerAt(std::uint64_t stamp)
{
    IgtlOffer offer;
    offer.stamp = stamp;
    offer.tools = {{"Tube", RigidTransform::translation({0.01, 0.02, 0.03}), true},
                   {"Jaw", RigidTransform::translation({0.04, 0.05, 0.06}), false}};
    static const auto landmarks =
        std::make_shared<const IgtlPoints>(IgtlPoints{{{"Carina", "Landmark", {}, {}, 0, ""}}});
    offer.landmarks = landmarks;
    auto lungs = std::make_shared<IgtlOffer::Surface>();
    lungs->name = "Lungs";
    lungs->data.points.resize(3);
    offer.surface = lungs;
    return offer;
}

/// The types of what is sent, with devices.
std::vector<std::string> sent(IgtlSubscriber& subscriber, const IgtlOffer& offer, LocalTime now)
{
    std::vector<std::string> told;
    for (const IgtlMessage& message : streamOf(subscriber.due(offer, now)).messages)
        told.push_back(typeOf(message.content) + " " + message.device);
    return told;
}

void ask(IgtlSubscriber& subscriber, IgtlContent content, std::string device = "Other",
         std::uint16_t version = 1)
{
    IgtlMessage message = messageOf(std::move(content), std::move(device));
    message.version = version;
    subscriber.take(encodeIgtl(message));
}

using Told = std::vector<std::string>;

} // namespace

class IgtlSubscriberTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesEverythingToWhoAsksForNothing()
    {
        IgtlSubscriber slicer{kStart};
        QVERIFY(sent(slicer, offerAt(1), kStart + milliseconds{299}).empty());
        QCOMPARE(sent(slicer, offerAt(1), kDecided),
                 (Told{"TRANSFORM Tube", "POINT Landmarks", "POLYDATA Lungs"}));
        const IgtlOffer next = offerAt(2);
        QCOMPARE(sent(slicer, next, kDecided + milliseconds{33}), Told{"TRANSFORM Tube"});
        QVERIFY(sent(slicer, next, kDecided + milliseconds{66}).empty());
        QCOMPARE(sent(slicer, next, kDecided + milliseconds{100}), Told{"POLYDATA Lungs"});
        QVERIFY(sent(slicer, next, kDecided + milliseconds{300}).empty());
    }

    void saysToVersion2WhatIsNotSeen()
    {
        IgtlSubscriber slicer{kStart};
        ask(slicer, IgtlStatus{}, "Slicer", 2);
        const auto stream = streamOf(slicer.due(offerAt(1), kDecided));
        QCOMPARE(stream.messages.size(), std::size_t{4});
        QCOMPARE(stream.messages[0].version, std::uint16_t{2});
        QCOMPARE(stream.messages[0].metadata.at(0).value, std::string{"OK"});
        QCOMPARE(stream.messages[1].device, std::string{"Jaw"});
        QCOMPARE(stream.messages[1].metadata.at(0).key, std::string{"TransformStatus"});
        QCOMPARE(stream.messages[1].metadata.at(0).value, std::string{"MISSING"});
        const auto X = poseOf(std::get<IgtlTransform>(stream.messages[1].content).matrix);
        QVERIFY((X->translation() - Vec3{0.04, 0.05, 0.06}).norm() < 1e-7);
    }

    void givesToWhoAsksWhatItAsksFor()
    {
        IgtlSubscriber client{kStart};
        ask(client, IgtlQuery{"GET_POLYDATA"}, "Mine");
        ask(client, IgtlQuery{"GET_POINT"}, "");
        ask(client, IgtlQuery{"GET_TRANS"}, "Tube");
        ask(client, IgtlQuery{"GET_TRANS"}, "Nose");
        ask(client, IgtlQuery{"GET_STATUS"});
        ask(client, IgtlQuery{"GET_SOMETHING"});
        QCOMPARE(sent(client, offerAt(1), kStart),
                 (Told{"POINT Landmarks", "POLYDATA Mine", "STATUS Carina", "TRANSFORM Tube"}));
        QVERIFY(sent(client, offerAt(2), kDecided).empty());
    }

    void saysThatThereIsNoSurface()
    {
        IgtlSubscriber client{kStart};
        ask(client, IgtlQuery{"GET_POLYDATA"});
        IgtlOffer offer = offerAt(1);
        offer.surface.reset();
        const auto stream = streamOf(client.due(offer, kStart));
        QCOMPARE(std::get<IgtlReply>(stream.messages.at(0).content).status, std::int8_t{1});
    }

    void sendsTrackingDataAtTheIntervalThatIsAskedFor()
    {
        for (const bool asQuaternions : {false, true}) {
            IgtlSubscriber client{kStart};
            ask(client, IgtlStart{asQuaternions, 100, "Patient"});
            const std::string type = asQuaternions ? "QTDATA" : "TDATA";
            QCOMPARE(sent(client, offerAt(1), kStart),
                     (Told{"RTS_" + type + " Carina", type + " Carina"}));
            int count = 0;
            for (int ms = 10; ms <= 1000; ms += 10)
                count += int(sent(client, offerAt(2), kStart + milliseconds{ms}).size());
            QCOMPARE(count, 10);
            ask(client, IgtlQuery{"STP_" + type});
            QVERIFY(sent(client, offerAt(3), kStart + milliseconds{1100}).empty());
        }
    }

    void leavesOutOfTrackingDataWhatIsNotSeen()
    {
        IgtlSubscriber client{kStart};
        ask(client, IgtlStart{false, 100, ""});
        const auto stream = streamOf(client.due(offerAt(1), kStart));
        const auto& tools = std::get<IgtlTrackingData>(stream.messages.at(1).content).tools;
        QCOMPARE(tools.size(), std::size_t{1});
        QCOMPARE(tools[0].name, std::string{"Tube"});
    }

    void boundsWhatItOwes()
    {
        IgtlSubscriber client{kStart};
        for (int i = 0; i < 1000; ++i)
            ask(client, IgtlQuery{"GET_POLYDATA"}, "Mine");
        QCOMPARE(sent(client, offerAt(1), kStart).size(), std::size_t{1});
        for (int i = 0; i < 1000; ++i)
            ask(client, IgtlQuery{"GET_POLYDATA"}, std::to_string(i));
        QVERIFY(sent(client, offerAt(1), kStart).size() <= 16);
        ask(client, IgtlStart{false, -5, ""}); // at most a hundred a second
        int count = 0;
        for (int ms = 1; ms <= 1000; ++ms)
            count += int(sent(client, offerAt(2), kStart + milliseconds{ms}).size());
        QVERIFY(count <= 102);
    }

    void tellsNowAndThenThatItIsThere()
    {
        IgtlSubscriber client{kStart};
        IgtlOffer nothing;
        nothing.landmarks = std::make_shared<const IgtlPoints>();
        QVERIFY(sent(client, nothing, kStart + milliseconds{1999}).empty());
        QCOMPARE(sent(client, nothing, kStart + seconds{2}), Told{"STATUS Carina"});
        QVERIFY(sent(client, nothing, kStart + seconds{3}).empty());
        QCOMPARE(sent(client, nothing, kStart + seconds{4}), Told{"STATUS Carina"});
    }

    void noticesWhatIsNotOpenIgtLink()
    {
        IgtlSubscriber client{kStart};
        const std::string text(100, 'x');
        client.take(std::as_bytes(std::span{text}));
        QVERIFY(client.isLost());
    }
};

CARINA_TEST(IgtlSubscriberTest)

} // namespace carina::igtl_subscriber_test

#include "tst_igtl_subscriber.moc"
