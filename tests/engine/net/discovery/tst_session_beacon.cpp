#include "engine/net/discovery/session_beacon.h"

#include "engine/core/monotonic_clock.h"

#include "engine/net/discovery/session_finder.h"
#include "engine/net/secure/dtls.h"
#include "tests/engine/net/discovery/notices.h"
#include "tests/engine/net/node/free_port.h"
#include "tests/support/patience.h"
#include "tests/support/test_class.h"

#include <set>

namespace carina::session_beacon_test
{

class SessionBeaconTest : public QObject
{
    Q_OBJECT

private:
    static std::set<std::string> namesIn(const SessionFinder& finder)
    {
        std::set<std::string> names;
        for (const FoundSession& found : finder.sessions())
            names.insert(found.notice.name);
        return names;
    }

private Q_SLOTS:
    void sessionsOfThisComputerAreFound()
    {
        const std::uint16_t port = freePort();
        const auto closed = SessionBeacon::open(noticeOf(1, "Closed"), false, port);
        const auto open = SessionBeacon::open(noticeOf(2, "Open"), true, port);
        const auto second = SessionBeacon::open(noticeOf(3, "Closed too"), false, port);
        QVERIFY(closed && open && second);
        int changes = 0;
        const SessionFinder finder{[&] { ++changes; }, port};
        QTRY_COMPARE_WITH_TIMEOUT(
            namesIn(finder), (std::set<std::string>{"Closed", "Closed too", "Open"}), kPatience_ms);
        QVERIFY(changes > 0);
        const auto found = finder.sessions();
        QVERIFY(found[0].notice == noticeOf(1, "Closed"));
        QVERIFY(QHostAddress{QString::fromStdString(found[0].address)}.isLoopback());
    }

    void hostThatIsNotOpenHearsThisComputerOnly()
    {
        const std::uint16_t port = freePort();
        const auto beacon = SessionBeacon::open(noticeOf(1), false, port);
        QVERIFY(beacon.has_value());
        QUdpSocket asker;
        QVERIFY(asker.bind(QHostAddress{QHostAddress::LocalHost}, 0));
        asker.writeDatagram(viewOf(encodeQuestion({.nonce = 5})),
                            QHostAddress{QHostAddress::LocalHost}, port);
        asker.writeDatagram(viewOf(encodeQuestion({.nonce = 6})),
                            QHostAddress{QStringLiteral("127.255.255.255")}, port);
        QTRY_VERIFY_WITH_TIMEOUT(asker.hasPendingDatagrams(), kPatience_ms);
        const auto answer = readRaw(asker);
        QVERIFY(decodeAnswer(std::as_bytes(octets(answer->bytes)), 6) == noticeOf(1));
        QVERIFY(!asker.hasPendingDatagrams()); // what was sent to an address of a network
    }

    /// A session that is joined by link answers who knows which one it is: those who were in it.
    void hiddenSessionAnswersWhoNamesIt()
    {
        const std::uint16_t port = freePort();
        const auto hidden =
            SessionBeacon::open(noticeOf(1), false, port, Announced::ToThoseWhoKnowIt);
        QVERIFY(hidden.has_value());
        QUdpSocket asker;
        QVERIFY(asker.bind(QHostAddress{QHostAddress::LocalHost}, 0));
        const QHostAddress all{QStringLiteral("127.255.255.255")};
        asker.writeDatagram(viewOf(encodeQuestion({.nonce = 5})), all, port);
        asker.writeDatagram(viewOf(encodeQuestion({6, noticeOf(2).session})), all, port);
        asker.writeDatagram(viewOf(encodeQuestion({7, noticeOf(1).session})), all, port);
        QTRY_VERIFY_WITH_TIMEOUT(asker.hasPendingDatagrams(), kPatience_ms);
        const auto answer = readRaw(asker);
        QVERIFY(decodeAnswer(std::as_bytes(octets(answer->bytes)), 7) == noticeOf(1));
        QVERIFY(!asker.hasPendingDatagrams());
    }

    /// As who was in one finds it, beside those that everybody does.
    void finderFindsTheHiddenSessionThatItKnows()
    {
        const std::uint16_t port = freePort();
        const auto hidden =
            SessionBeacon::open(noticeOf(1, "Hidden"), false, port, Announced::ToThoseWhoKnowIt);
        const auto shown = SessionBeacon::open(noticeOf(2, "Shown"), false, port);
        QVERIFY(hidden && shown);
        SessionFinder finder{[] {}, port};
        QTRY_COMPARE_WITH_TIMEOUT(namesIn(finder), std::set<std::string>{"Shown"}, kPatience_ms);
        finder.lookFor(noticeOf(1).session);
        QTRY_COMPARE_WITH_TIMEOUT(namesIn(finder), (std::set<std::string>{"Hidden", "Shown"}),
                                  kPatience_ms);
    }

    void floodOfQuestionsGetsFewAnswers()
    {
        const std::uint16_t port = freePort();
        const auto beacon = SessionBeacon::open(noticeOf(1), false, port);
        QUdpSocket flood;
        QVERIFY(flood.bind(QHostAddress{QHostAddress::LocalHost}, 0));
        const QHostAddress all{QStringLiteral("127.255.255.255")};
        const LocalTime begin = monotonicNow();
        for (int i = 0; i < 500; ++i) {
            flood.writeDatagram(viewOf(encodeQuestion({.nonce = 5})), all, port);
            QCoreApplication::processEvents();
        }
        flood.writeDatagram("no question", all, port);
        QCoreApplication::processEvents();
        int answers = 0;
        while (readRaw(flood))
            ++answers;
        const auto refilled = (monotonicNow() - begin) / SourceLimiter::kRate.interval;
        QVERIFY(answers > 0);
        QVERIFY(answers <= SourceLimiter::kRate.burst + refilled);
    }
};

CARINA_TEST(SessionBeaconTest)

} // namespace carina::session_beacon_test

#include "tst_session_beacon.moc"
