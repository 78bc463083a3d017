#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/breathing/breathing_panel.h"

#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QSpinBox>

namespace carina::breathing_panel_test
{

using test::FakeSessionNode;

class TestBreathingPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void offersOnlyVolumesOfThisPatient();
    void refusesATypedVolumeWithItsRange();
    void saysHowToHaveNoBreaths();
    void stopsTheBreathing();
    void squeezesABag();
};

void TestBreathingPanel::offersOnlyVolumesOfThisPatient()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel model{session, FakeSessionNode::kStation};
    BreathingPanel panel;
    panel.setModel(model);
    const auto& box = *panel.findChild<QSpinBox*>(QStringLiteral("tidalVolume"));
    const auto& slider = *panel.findChild<QSlider*>(QStringLiteral("tidalVolumeSlider"));
    QCOMPARE(box.maximum(), 1000); // 25 ml for each of 40 kg
    QCOMPARE(slider.maximum(), 1000);
    QVERIFY(box.toolTip().contains(QStringLiteral("1000")));
    node.decide(fact::PatientBuildSet{{metres(1.75), 77.0, 40.0, Sex::Male}});
    QCoreApplication::sendPostedEvents();
    QCOMPARE(box.maximum(), 1925);
    QCOMPARE(slider.maximum(), 1925);
    QCOMPARE(node.proposed, 0); // a bound asks for nothing
}

void TestBreathingPanel::saysHowToHaveNoBreaths()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel model{session, FakeSessionNode::kStation};
    BreathingPanel panel;
    panel.setModel(model);
    panel.show();
    auto& box = *panel.findChild<QSpinBox*>(QStringLiteral("rate"));
    const auto& refused = *panel.findChild<QLabel*>(QStringLiteral("refused"));
    const auto type = [&](const char* number) {
        box.selectAll();
        QTest::keyClicks(&box, QString::fromLatin1(number));
        QTest::keyClick(&box, Qt::Key_Return);
        return refused.text();
    };
    const QString advice = QStringLiteral("tick “Breathing stops”");
    QVERIFY2(type("0").contains(advice), qPrintable(refused.text()));
    QVERIFY(refused.text().contains(QStringLiteral("4 to 60")));
    QVERIFY2(!type("99").contains(advice), qPrintable(refused.text()));
}

// It was 999.
void TestBreathingPanel::refusesATypedVolumeWithItsRange()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel model{session, FakeSessionNode::kStation};
    BreathingPanel panel;
    panel.setModel(model);
    panel.show();
    auto& box = *panel.findChild<QSpinBox*>(QStringLiteral("tidalVolume"));
    const auto& refused = *panel.findChild<QLabel*>(QStringLiteral("refused"));
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("9999"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(box.value(), 280);
    QCOMPARE(node.proposed, 0);
    QVERIFY(refused.isVisible());
    QVERIFY2(refused.text().contains(QStringLiteral("9999")), qPrintable(refused.text()));
    box.selectAll();
    QTest::keyClicks(&box, QStringLiteral("400"));
    QTest::keyClick(&box, Qt::Key_Return);
    QCOMPARE(node.proposed, 1);
    QVERIFY(!refused.isVisible());
}

void TestBreathingPanel::stopsTheBreathing()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel model{session, FakeSessionNode::kStation};
    BreathingPanel panel;
    panel.setModel(model);
    panel.show();
    auto& stops = *panel.findChild<QCheckBox*>(QStringLiteral("stops"));
    const auto& left = *panel.findChild<QLabel*>(QStringLiteral("breathingLeft"));
    QVERIFY(!stops.isChecked() && !left.isVisible());
    stops.click();
    node.advance(std::chrono::seconds{1});
    node.announce();
    QCoreApplication::sendPostedEvents();
    const auto state = node.state();
    const auto& respiration = state->stations().at(FakeSessionNode::kStation).respiration;
    QCOMPARE(respiration.settingsAt(SessionTime::max()).ownBreathing, 0.0);
    QVERIFY(stops.isChecked() && left.isVisible());
    QVERIFY2(left.text().contains(QStringLiteral("Apnoea")), qPrintable(left.text()));
}

void TestBreathingPanel::squeezesABag()
{
    FakeSessionNode node;
    SessionModel session{node};
    BreathingModel model{session, FakeSessionNode::kStation};
    BreathingPanel panel;
    panel.setModel(model);
    auto& rate = *panel.findChild<QSpinBox*>(QStringLiteral("bagRate"));
    QCOMPARE(rate.text(), QStringLiteral("none"));
    rate.setValue(12);
    const auto state = node.state();
    const auto& respiration = state->stations().at(FakeSessionNode::kStation).respiration;
    QVERIFY(std::abs(inPerMinute(respiration.settingsAt(SessionTime::max()).bag.rate) - 12.0)
            < 1e-9);
}

CARINA_SCREEN_TEST(TestBreathingPanel)

} // namespace carina::breathing_panel_test

#include "tst_breathing_panel.moc"
