#include "tests/models/fake_session_node.h"
#include "tests/support/test_class.h"
#include "ui/panels/breathing_panel.h"

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

CARINA_SCREEN_TEST(TestBreathingPanel)

} // namespace carina::breathing_panel_test

#include "tst_breathing_panel.moc"
