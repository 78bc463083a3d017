#include "tests/support/patience.h"
#include "ui/tracker/server_fields.h"
#include "ui/tracker/tracker_dialog.h"

#include "engine/net/devices/igtl_server.h"
#include "tests/engine/net/devices/igtl_offers.h"
#include "tests/support/test_class.h"

#include <QAbstractButton>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTableWidget>

namespace carina::server_fields_test
{
namespace
{

template <class Widget> Widget& find(const QWidget& window, const char* name)
{
    return *window.findChild<Widget*>(QLatin1String{name});
}

} // namespace

class ServerFieldsTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void findsTheToolsThatAServerSends()
    {
        const auto server = IgtlServer::listen({"127.0.0.1", 0}).value();
        TrackerDialog dialog{{.source = TrackerSource::OpenIgtLink}, {}};
        dialog.show();
        QVERIFY(find<QLineEdit>(dialog, "server").isVisible());
        QVERIFY(!find<QAbstractButton>(dialog, "use").isEnabled());
        QVERIFY(!find<QAbstractButton>(dialog, "look").isEnabled());
        find<QLineEdit>(dialog, "server")
            .setText(QStringLiteral("127.0.0.1:%1").arg(server->port()));
        QVERIFY(find<QLabel>(dialog, "missing").text().contains(QStringLiteral("look")));
        find<QAbstractButton>(dialog, "look").click();
        int given = 0;
        const auto isFound = [&] {
            ++given;
            server->give(test::tubeOffer(std::uint64_t(given) << 28U, given));
            return find<QAbstractButton>(dialog, "addSent").isEnabled();
        };
        QTRY_VERIFY_WITH_TIMEOUT(isFound(), kPatience_ms);
        QVERIFY(find<QLabel>(dialog, "sent").text().contains(QStringLiteral("Tube")));
        find<QAbstractButton>(dialog, "addSent").click();
        const std::vector<ServedTool> expected{{QStringLiteral("Tube"), ToolRole::Tube}};
        QCOMPARE(dialog.form().served, expected);
        const auto isSeen = [&] {
            ++given;
            server->give(test::tubeOffer(std::uint64_t(given) << 28U, given));
            return find<QLabel>(dialog, "sent").text().contains(QStringLiteral("✓ Tube: visible"));
        };
        QTRY_VERIFY_WITH_TIMEOUT(isSeen(), kPatience_ms);
        find<QAbstractButton>(dialog, "use").click();
        QTRY_COMPARE(dialog.result(), int(QDialog::Accepted));
        const auto& described = std::get<TrackerDescription>(dialog.choice().device);
        QCOMPARE(described.kind, TrackerKind::OpenIgtLink);
        QCOMPARE(described.tools[0].device, std::string{"Tube"});
        QCOMPARE(described.tools[0].role, ToolRole::Tube);
    }

    void saysWhatIsMissing()
    {
        TrackerDialog dialog{{.source = TrackerSource::OpenIgtLink,
                              .server = QStringLiteral("192.0.2.7:18944"),
                              .served = {{QStringLiteral("A"), ToolRole::Tube},
                                         {QStringLiteral("A"), ToolRole::Jaw}}},
                             {}};
        const auto& missing = find<QLabel>(dialog, "missing");
        QVERIFY(missing.text().contains(QStringLiteral("twice")));
        auto& table = find<QTableWidget>(dialog, "served");
        table.item(1, 0)->setText(QStringLiteral("B"));
        QCOMPARE(missing.text(), QString{});
        qobject_cast<QComboBox*>(table.cellWidget(1, 1))->setCurrentText(QStringLiteral("Tube"));
        QVERIFY(missing.text().contains(QStringLiteral("Tube")));
        find<QAbstractButton>(dialog, "removeServed").click();
        QCOMPARE(missing.text(), QString{});
        find<QAbstractButton>(dialog, "addServed").click();
        QVERIFY(missing.text().contains(QStringLiteral("name")));
        find<QLineEdit>(dialog, "server").setText(QStringLiteral("/dev/ttyUSB0"));
        QVERIFY(missing.text().contains(QStringLiteral("address and port of the server")));
    }

    void saysThatNoServerAnswers()
    {
        const auto port = IgtlServer::listen({"127.0.0.1", 0}).value()->port();
        TrackerDialog dialog{{.source = TrackerSource::OpenIgtLink,
                              .server = QStringLiteral("127.0.0.1:%1").arg(port)},
                             {}};
        find<QAbstractButton>(dialog, "look").click();
        QTRY_VERIFY_WITH_TIMEOUT(
            find<QLabel>(dialog, "sent")
                .text()
                .startsWith(QStringLiteral("▲ No server of OpenIGTLink answers")),
            kPatience_ms);
    }

    void tellsRolesByTheNamesOfPlus()
    {
        QCOMPARE(freeRoleOf(QStringLiteral("StylusToTracker"), {}), ToolRole::Stylus);
        QCOMPARE(freeRoleOf(QStringLiteral("laryngoscope"), {}), ToolRole::Laryngoscope);
        QCOMPARE(freeRoleOf(QStringLiteral("Tom"), {}), ToolRole::Other);
        QCOMPARE(freeRoleOf(QStringLiteral("ETT"), {{QStringLiteral("Tube"), ToolRole::Tube}}),
                 ToolRole::Other);
    }

    void everyControlHasANameForAScreenReader()
    {
        ServerFields fields;
        fields.fill({.served = {{}}});
        QVERIFY(!find<QLineEdit>(fields, "server").accessibleName().isEmpty());
        QVERIFY(!find<QTableWidget>(fields, "served").accessibleName().isEmpty());
        for (const QComboBox* box : fields.findChildren<QComboBox*>())
            QVERIFY(!box->accessibleName().isEmpty());
    }
};

CARINA_SCREEN_TEST(ServerFieldsTest)

} // namespace carina::server_fields_test

#include "tst_server_fields.moc"
