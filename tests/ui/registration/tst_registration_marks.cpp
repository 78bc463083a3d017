#include "tests/support/patience.h"
#include "tests/support/test_class.h"
#include "tests/ui/registration/registration_desk.h"
#include "widgets/scene/view/graphics.h"
#include "widgets/scene/view/scene_view.h"

#include <algorithm>

namespace carina::registration_marks_test
{
namespace
{

constexpr int kFrames = 3;
constexpr int kReach = 16;        ///< pixels, beyond the largest mark
constexpr double kContrast = 3.0; ///< that WCAG 2.1 asks of what is no text

/// Relative luminance, as WCAG has it.
double luminance(const QColor& color)
{
    const auto linear = [](double c) {
        return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF())
           + 0.0722 * linear(color.blueF());
}

double contrast(double a, double b) { return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05); }

QImage pictureOf(SceneView& scene)
{
    scene.setFixedQuality(PictureQuality::Quick);
    const std::size_t target = scene.statistics().frames + kFrames;
    if (!QTest::qWaitFor([&] { return scene.statistics().frames >= target; }, kPatience_ms))
        return {};
    return scene.picture();
}

} // namespace

/// What marks the landmarks on the patient.
class TestRegistrationMarks : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    /// Touched, next and open ones of the rib cage, which is seen from the front.
    void standOutWithoutColours()
    {
        RegistrationDesk desk;
        desk.site.prepare(*desk.model);
        desk.site.touchFirst(*desk.model, 2);
        auto& scene = desk.find<SceneView>("scene");
        scene.showFrom(ViewPreset::Front);
        const QImage picture = pictureOf(scene);
        QVERIFY(!picture.isNull());
        for (std::size_t i = 0; i < 4; ++i) {
            const Landmark landmark = desk.site.landmarks()[i];
            const auto seen =
                seenPoint(landmark.p_AQ, {scene.camera().pose(), scene.camera().frustum()});
            QVERIFY(seen);
            const QPoint middle{int(seen->at.x() * picture.width()),
                                int(seen->at.y() * picture.height())};
            double darkest = 1.0;
            for (int right = 0; right < kReach; ++right)
                darkest =
                    std::min(darkest, luminance(picture.pixelColor(middle + QPoint{right, 0})));
            const double found = contrast(luminance(picture.pixelColor(middle)), darkest);
            QVERIFY2(found > kContrast, qPrintable(QStringLiteral("%1: %2")
                                                       .arg(QString::fromStdString(landmark.name))
                                                       .arg(found)));
        }
    }
};

CARINA_SCREEN_TEST(TestRegistrationMarks)

} // namespace carina::registration_marks_test

#include "tst_registration_marks.moc"
