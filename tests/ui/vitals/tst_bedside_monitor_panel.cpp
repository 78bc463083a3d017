#include "tests/engine/audio/gain_of.h"
#include "tests/support/test_class.h"
#include "ui/vitals/bedside_monitor_panel.h"
#include "ui/vitals/sound_controls.h"
#include "widgets/vitals/bedside_monitor.h"

#include <QAbstractButton>
#include <QAction>
#include <QCheckBox>
#include <QLabel>
#include <QSlider>

#include <algorithm>

namespace carina::bedside_monitor_panel_test
{
namespace
{

constexpr double kGrown_years = 40.0;

/// A patient whose saturation is chosen, a monitor, and a stethoscope.
struct Desk {
    SessionTime now{std::chrono::seconds{96}}; ///< a sweep begins
    double saturation = 0.97;
    std::optional<AuscultationGains> stethoscope{};
    VitalsModel model{
        {.now = [this] { return std::optional{now}; },
         .vitals = [this](SessionTime) { return std::optional{vitals()}; },
         .breath =
             [](SessionTime) { return std::optional{BreathFlows{.right = litresPerSecond(0.5)}}; },
         .stethoscope = [this](SessionTime) { return stethoscope; }},
        kGrown_years};
    SoundOutput output{
        [](std::span<float> samples) { std::fill(samples.begin(), samples.end(), 0.0F); }};
    BedsideMonitorPanel panel;

    Desk() { panel.setModel(model, output); }

    [[nodiscard]] Vitals vitals() const
    {
        Vitals vitals;
        vitals.saturation = saturation;
        vitals.heartRate = perMinute(70.0);
        vitals.systolic = mmHg(120.0);
        vitals.diastolic = mmHg(80.0);
        vitals.mean = mmHg(93.0);
        return vitals;
    }

    void pass(double seconds)
    {
        for (double t = 0.0; t < seconds; t += 0.1) {
            now += std::chrono::milliseconds{100};
            model.look();
        }
    }

    template <class Control> [[nodiscard]] Control& control(const char* name) const
    {
        return *panel.findChild<Control*>(QLatin1String{name});
    }
    [[nodiscard]] BedsideMonitor& monitor() const { return *panel.findChild<BedsideMonitor*>(); }
    [[nodiscard]] QString told() const { return monitor().words(); }
};

} // namespace

class TestBedsideMonitorPanel : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void showsCurvesAndNumbers()
    {
        Desk desk;
        desk.pass(2.0);
        QVERIFY2(desk.told().contains(QStringLiteral("SpO2 97 per cent")), qPrintable(desk.told()));
        QVERIFY(desk.told().contains(QStringLiteral("120 over 80, mean 93")));
        for (const auto row : {BedsideMonitor::Row::Electrocardiogram, BedsideMonitor::Row::Pulse})
            QCOMPARE(desk.monitor().drawing().strips[std::size_t(row)].lines.size(),
                     std::size_t{1});
        desk.model.startAfresh(kGrown_years);
        QVERIFY(desk.monitor().drawing().strips[0].lines.empty());
    }

    void silencesAnAlarm()
    {
        Desk desk;
        desk.pass(2.0);
        auto& silence = desk.control<QAbstractButton>("silence");
        QVERIFY(!silence.isEnabled());
        desk.saturation = 0.84;
        desk.pass(VitalAlarms::kDelay_s + 0.5);
        QVERIFY2(desk.told().contains(QStringLiteral("alarm of high priority: SpO2 below 85")),
                 qPrintable(desk.told()));
        QVERIFY(silence.isEnabled());
        silence.click();
        QVERIFY(desk.model.isSilenced());
        QVERIFY(!silence.isEnabled());
        QVERIFY(desk.told().contains(QStringLiteral("alarm of high priority"))); // still shown
    }

    void mutesAllAndThenOnlyWhatWasMuteByItself()
    {
        Desk desk;
        desk.pass(0.5);
        desk.model.setLoudness(SoundKind::Heart, {70, true});
        auto& mute = desk.control<QAbstractButton>("soundsButton");
        mute.click();
        QVERIFY(desk.model.isMuted());
        QVERIFY(mute.isChecked() && mute.text().contains(QStringLiteral("■")));
        mute.click();
        QVERIFY(!desk.model.isMuted() && !mute.isChecked());
        for (const SoundKind kind : kSoundKinds)
            QCOMPARE(desk.model.loudness(kind).isMuted, kind == SoundKind::Heart);
        desk.panel.muteAction()->trigger(); // by key or menu
        QVERIFY(desk.model.isMuted() && mute.isChecked());
    }

    void isHeardWhileItIsInSight()
    {
        Desk desk;
        const auto isHeard = [&desk] {
            return test::gainOf(desk.model.sounds().mixer(), SoundKind::Alarm) > 0.0;
        };
        QVERIFY(!isHeard());
        desk.panel.show();
        QVERIFY(isHeard());
        desk.panel.setEnabled(false); // behind other panels
        QVERIFY(!isHeard());
        desk.panel.setEnabled(true);
        QVERIFY(isHeard());
        desk.panel.hide();
        QVERIFY(!isHeard());
    }

    void setsTheVolumeOfEachSound()
    {
        Desk desk;
        desk.panel.show();
        auto& volumes = desk.control<QAbstractButton>("volumes");
        QVERIFY(!desk.control<QSlider>("volume0").isVisible());
        volumes.click();
        for (const SoundKind kind : kSoundKinds) {
            const QString number = QString::number(int(kind));
            auto& slider =
                desk.control<QSlider>(qPrintable(QStringLiteral("volume%1").arg(number)));
            auto& played =
                desk.control<QCheckBox>(qPrintable(QStringLiteral("played%1").arg(number)));
            QVERIFY(slider.isVisible() && played.isChecked());
            slider.setValue(20 + int(kind));
            QCOMPARE(desk.model.loudness(kind).volume_percent, 20 + int(kind));
            QTest::keyClick(&played, Qt::Key_Space);
            QVERIFY(desk.model.loudness(kind).isMuted);
        }
        desk.model.setLoudness(SoundKind::Alarm, {55, false});
        QCOMPARE(desk.control<QSlider>("volume1").value(), 55);
        QVERIFY(desk.control<QCheckBox>("played1").isChecked());
    }

    void saysWhatTheStethoscopeHears()
    {
        Desk desk;
        desk.pass(0.5);
        const auto& heard = desk.control<QLabel>("heard");
        QVERIFY(heard.text().contains(QStringLiteral("not on the chest")));
        desk.stethoscope = AuscultationGains{.right = 1.0};
        desk.pass(0.5);
        QVERIFY2(heard.text().contains(QStringLiteral("right lung")), qPrintable(heard.text()));
        desk.stethoscope = AuscultationGains{.left = 1.0};
        desk.pass(3.0);
        QVERIFY2(heard.text().contains(QStringLiteral("nothing is heard")),
                 qPrintable(heard.text()));
    }

    void saysWhyNothingIsPlayed()
    {
        Desk desk;
        desk.panel.show();
        const auto& obstacle = desk.control<QLabel>("noSound");
        QVERIFY(!obstacle.isVisible());
        desk.control<QAbstractButton>("volumes").click();
        QCOMPARE(obstacle.isVisible(), !desk.output.obstacle().isEmpty());
        QCOMPARE(obstacle.text(), desk.output.obstacle());
    }

    void namesEveryControl()
    {
        Desk desk;
        for (const QWidget* control : desk.panel.findChildren<QWidget*>())
            if (control->focusPolicy() != Qt::NoFocus)
                QVERIFY2(!control->accessibleName().isEmpty(), qPrintable(control->objectName()));
    }
};

CARINA_SCREEN_TEST(TestBedsideMonitorPanel)

} // namespace carina::bedside_monitor_panel_test

#include "tst_bedside_monitor_panel.moc"
