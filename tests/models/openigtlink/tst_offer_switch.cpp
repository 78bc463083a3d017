#include "models/openigtlink/offer_switch.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "engine/tracking/igtl/igtl_reader.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/soon.h"
#include "tests/support/test_class.h"

#include <QSignalSpy>
#include <QTcpSocket>

namespace carina::offer_switch_test
{
namespace
{

using test::FakeSessionNode;
using test::soon;

constexpr std::size_t kMostRead = 8U << 20U;

/// A station with the built-in child, and the switch.
struct Desk {
    SharedPatientModel patient =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    FakeSessionNode node;
    StationView view{node, FakeSessionNode::kStation, patient->lungs()};
    OfferSwitch offer{[this] { return OfferGiver::Shown{view, *patient}; }};
};

/// A program of somebody else that reads along.
class Reader
{
public:
    explicit Reader(std::uint16_t port)
    {
        m_socket.connectToHost(QStringLiteral("127.0.0.1"), port);
    }

    /// Whether the landmarks have come.
    [[nodiscard]] bool hasLandmarks()
    {
        const QByteArray bytes = m_socket.readAll();
        m_reader.take(std::as_bytes(std::span{bytes.constData(), std::size_t(bytes.size())}));
        while (const auto message = m_reader.next())
            if (*message && std::holds_alternative<IgtlPoints>((*message)->content))
                m_hasLandmarks = true;
        return m_hasLandmarks;
    }
    [[nodiscard]] bool isCutOff() const
    {
        return m_socket.state() == QAbstractSocket::UnconnectedState;
    }

private:
    QTcpSocket m_socket;
    IgtlReader m_reader{kMostRead};
    bool m_hasLandmarks = false;
};

} // namespace

class OfferSwitchTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void isOffUntilItIsSwitchedOn()
    {
        Desk desk;
        QVERIFY(!desk.offer.isOn() && !desk.offer.isOpen());
        QCOMPARE(desk.offer.clients(), 0);
        QCOMPARE(desk.offer.text(), QString{});
    }

    void givesToThisComputerAndTellsHowManyRead()
    {
        Desk desk;
        desk.node.loseClock(); // the patient at rest
        const QSignalSpy changed{&desk.offer, &OfferSwitch::changed};
        QVERIFY(desk.offer.begin({"127.0.0.1", 0}));
        QCOMPARE(changed.size(), 1);
        QVERIFY(desk.offer.isOn() && !desk.offer.isOpen());
        const std::uint16_t port = desk.offer.place().port;
        QVERIFY(port != 0);
        QVERIFY(desk.offer.text().startsWith(QStringLiteral("●")));
        QVERIFY(desk.offer.text().contains(QStringLiteral("127.0.0.1:%1").arg(port)));
        QVERIFY(desk.offer.text().contains(QStringLiteral("clear text")));
        QVERIFY(desk.offer.text().endsWith(QStringLiteral("now: 0.")));
        Reader reader{port};
        QVERIFY(soon([&] { return desk.offer.text().endsWith(QStringLiteral("now: 1.")); }));
        QVERIFY(soon([&] { return reader.hasLandmarks(); }));
        desk.offer.end();
        QCOMPARE(changed.size(), 2);
        QVERIFY(!desk.offer.isOn());
        QVERIFY(soon([&] { return reader.isCutOff(); }));
        desk.offer.end(); // which is nothing new
        QCOMPARE(changed.size(), 2);
    }

    void warnsWhileOtherComputersCanReach()
    {
        Desk desk;
        QVERIFY(desk.offer.begin({"0.0.0.0", 0}));
        QVERIFY(desk.offer.isOpen());
        QVERIFY(desk.offer.text().startsWith(QStringLiteral("▲ Warning")));
        desk.offer.end();
        QVERIFY(!desk.offer.isOpen());
    }

    void staysAsItIsWhereAPortIsTaken()
    {
        Desk desk;
        const auto other = IgtlServer::listen({"127.0.0.1", 0}).value();
        const auto refused = desk.offer.begin({"127.0.0.1", other->port()});
        QVERIFY(!refused);
        QCOMPARE(refused.error().code, Errc::AddressInUse);
        QVERIFY(!desk.offer.isOn());
        QVERIFY(desk.offer.begin({"127.0.0.1", 0}));
        const std::uint16_t port = desk.offer.place().port;
        QVERIFY(!desk.offer.begin({"127.0.0.1", other->port()}));
        QCOMPARE(desk.offer.place().port, port);
    }
};

CARINA_TEST(OfferSwitchTest)

} // namespace carina::offer_switch_test

#include "tst_offer_switch.moc"
