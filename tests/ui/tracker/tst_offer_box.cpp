#include "ui/tracker/offer_box.h"

#include "engine/anatomy/patient/builtin_patient.h"
#include "models/patient/patient_source.h"
#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "tests/ui/access/control_walk.h"
#include "ui/tracker/offer_dialog.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QSpinBox>
#include <QTcpServer>

namespace carina::offer_box_test
{
namespace
{

using test::FakeSessionNode;

quint16 freeTcpPort()
{
    QTcpServer probe;
    return probe.listen(QHostAddress::LocalHost) ? probe.serverPort() : quint16{0};
}

/// The box over a station with the built-in child.
struct Desk {
    SharedPatientModel patient =
        patientOf(builtinPatient(BuiltinPatient::TwelveYears).value()).value();
    FakeSessionNode node;
    StationView view{node, FakeSessionNode::kStation, patient->lungs()};
    OfferSwitch offer{[this] { return OfferGiver::Shown{view, *patient}; }};
    OfferBox box{offer};

    Desk() { box.show(); }
    [[nodiscard]] QPushButton& button() const
    {
        return *box.findChild<QPushButton*>(QStringLiteral("offer"));
    }
    [[nodiscard]] QLabel& text() const
    {
        return *box.findChild<QLabel*>(QStringLiteral("offered"));
    }
    /// The window that asks; null where none does.
    [[nodiscard]] OfferDialog* dialog() const
    {
        for (OfferDialog* each : box.findChildren<OfferDialog*>())
            if (each->isVisible())
                return each;
        return nullptr;
    }
};

template <class Widget> Widget& find(const QWidget& window, const char* name)
{
    return *window.findChild<Widget*>(QLatin1String{name});
}

} // namespace

class TestOfferBox : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void givesToThisComputerUnlessItIsOpened()
    {
        Desk desk;
        QVERIFY(desk.text().isHidden());
        desk.button().click();
        OfferDialog* dialog = desk.dialog();
        QVERIFY(dialog);
        QVERIFY(!find<QCheckBox>(*dialog, "offerOpen").isChecked());
        const auto& warning = find<QLabel>(*dialog, "offerWarning");
        QVERIFY(warning.text().contains(QStringLiteral("127.0.0.1:18944")));
        QVERIFY(!desk.offer.isOn()); // nothing is given before a person says so
        const quint16 port = freeTcpPort();
        find<QSpinBox>(*dialog, "offerPort").setValue(port);
        QVERIFY(warning.text().contains(QString::number(port)));
        find<QPushButton>(*dialog, "offerGive").click();
        QVERIFY(desk.offer.isOn() && !desk.offer.isOpen());
        QVERIFY(!desk.text().isHidden());
        QCOMPARE(desk.text().text(), desk.offer.text());
        QVERIFY(desk.text().text().contains(QString::number(port)));
        desk.button().click(); // which ends it
        QVERIFY(!desk.offer.isOn());
        QVERIFY(desk.text().isHidden());
    }

    void warnsBeforeItIsOpenedToOtherComputers()
    {
        Desk desk;
        desk.button().click();
        OfferDialog* dialog = desk.dialog();
        QVERIFY(dialog);
        find<QCheckBox>(*dialog, "offerOpen").click();
        QVERIFY(find<QLabel>(*dialog, "offerWarning").text().startsWith(QStringLiteral("Warning")));
        find<QSpinBox>(*dialog, "offerPort").setValue(freeTcpPort());
        find<QPushButton>(*dialog, "offerGive").click();
        QVERIFY(desk.offer.isOpen());
        QVERIFY(desk.text().text().startsWith(QStringLiteral("▲")));
    }

    void saysWhyItCannotBeGiven()
    {
        QTcpServer taken;
        QVERIFY(taken.listen(QHostAddress::LocalHost));
        Desk desk;
        desk.button().click();
        OfferDialog* dialog = desk.dialog();
        QVERIFY(dialog);
        find<QSpinBox>(*dialog, "offerPort").setValue(taken.serverPort());
        find<QPushButton>(*dialog, "offerGive").click();
        QVERIFY(dialog->isVisible());
        QVERIFY(find<QLabel>(*dialog, "offerProblem").text().startsWith(QStringLiteral("▲")));
        QVERIFY(!desk.offer.isOn());
        find<QSpinBox>(*dialog, "offerPort").setValue(freeTcpPort());
        QCOMPARE(find<QLabel>(*dialog, "offerProblem").text(), QString{});
    }

    void isWorkedByKeyboard()
    {
        const Desk desk;
        OfferSwitch offer{[&desk] { return OfferGiver::Shown{desk.view, *desk.patient}; }};
        OfferDialog dialog{offer};
        dialog.show();
        test::verifyControls(dialog);
    }
};

CARINA_SCREEN_TEST(TestOfferBox)

} // namespace carina::offer_box_test

#include "tst_offer_box.moc"
