#include "apps/lab/commands.h"
#include "apps/lab/rendering/event_option.h"
#include "apps/lab/rendering/geometry_check.h"
#include "apps/lab/rendering/seen_balls.h"
#include "engine/anatomy/patient/builtin_patient.h"
#include "models/airway/airway_presets.h"
#include "tests/support/eye_projection.h"
#include "tests/support/test_class.h"
#include "widgets/scene/view/graphics.h"

#include <cmath>

namespace carina::render_command_test
{

namespace
{

constexpr double kProjectionTolerance_px = 1.0;
constexpr double kExact_px = 1e-9;

} // namespace

class TestRenderCommand : public QObject
{
    Q_OBJECT

public:
    static void initMain() { prepareGraphics(); }

private Q_SLOTS:
    void tellsWhereABallIsSeen();
    void tellsHowFarABallReaches();
    void tellsBallsApartHoweverTheyAreLit();
    void drawsEachBallWhereItIsSeen_data();
    void drawsEachBallWhereItIsSeen();
    void drawsWhatTheSeedSays();
    void listsEveryPreset();
    void refusesWhatItDoesNotKnow_data();
    void refusesWhatItDoesNotKnow();
};

// The truth itself, by hand: the screen spans x from -0.4 to 0.6 and y from -0.2 to 0.3 at z = -2;
// the eye is at (0.1, 0, 0). In an area of 200 by 300 pixels 200 by 100 of them show the screen.
void TestRenderCommand::tellsWhereABallIsSeen()
{
    const test::EyeBeforeScreen eye{{0.1, 0.0, 0.0}, {0.1, 0.05, -2.0}, 1.0, 0.5};
    const test::PixelArea area = test::screenWithin(eye, {200.0, 0.0, 200.0, 300.0});
    QCOMPARE(area.left, 200.0);
    QCOMPARE(area.top, 100.0);
    QCOMPARE(area.width, 200.0);
    QCOMPARE(area.height, 100.0);
    // Half way to the screen, 0.1 m right of the eye and 0.05 m up: on the screen twice that.
    const auto ball = test::seenBall(eye, area, {0.2, 0.05, -1.0}, 0.001);
    QVERIFY(ball.has_value());
    QVERIFY(std::abs(ball->x - (200.0 + 200.0 * 0.7)) < kExact_px);
    QVERIFY(std::abs(ball->y - (100.0 + 200.0 * 0.2)) < kExact_px);
    QVERIFY(!test::seenBall(eye, area, {0.2, 0.05, 1.0}, 0.001));
    QVERIFY(!test::seenBall(eye, area, {0.1, 0.0, -0.001}, 0.001));
}

void TestRenderCommand::tellsHowFarABallReaches()
{
    const test::EyeBeforeScreen eye{Vec3::Zero(), {0.0, 0.0, -1.0}, 2.0, 2.0};
    const test::PixelArea area{0.0, 0.0, 1000.0, 1000.0};
    constexpr double kRadius = 0.02;
    const Vec3 p_HQ{0.3, -0.2, -0.6};
    const auto ball = test::seenBall(eye, area, p_HQ, kRadius);
    double furthest_px = 0.0;
    for (int i = 0; i < 10'000; ++i) { // points all over the ball
        const double z = 2.0 * (i + 0.5) / 10'000 - 1.0;
        const double around = 2.399963229728653 * i; // the golden angle
        const double ring = std::sqrt(1.0 - z * z);
        const auto point = test::seenBall(
            eye, area, p_HQ + kRadius * Vec3{ring * std::cos(around), ring * std::sin(around), z},
            0.0);
        furthest_px = std::max(furthest_px, std::hypot(point->x - ball->x, point->y - ball->y));
    }
    QVERIFY(furthest_px <= ball->reach + kExact_px);
    QVERIFY(furthest_px > 0.99 * ball->reach);
}

void TestRenderCommand::tellsBallsApartHoweverTheyAreLit()
{
    QImage picture{40, 10, QImage::Format_RGB32};
    picture.fill(Qt::black);
    for (std::size_t ball = 0; ball < lab::kBallColors; ++ball) {
        const QColor full = lab::ballColor(ball);
        const int x = 10 + 3 * static_cast<int>(ball);
        picture.setPixelColor(x, 4, full);
        picture.setPixelColor(x + 1, 4, full.darker(400));
        picture.setPixelColor(x + 1, 5,
                              QColor(full.red() / 2 + 60, full.green() / 2 + 60,
                                     full.blue() / 2 + 60)); // in a highlight
    }
    picture.setPixelColor(0, 0, Qt::white); // outside the part
    const auto found = lab::ballsIn(picture, QRect{1, 1, 39, 9});
    for (std::size_t ball = 0; ball < lab::kBallColors; ++ball) {
        QCOMPARE(found[ball].count, 3);
        QVERIFY(std::abs(found[ball].x - (10.5 + 3.0 * double(ball) + 2.0 / 3.0)) < kExact_px);
        QVERIFY(std::abs(found[ball].y - (4.5 + 1.0 / 3.0)) < kExact_px);
    }
}

void TestRenderCommand::drawsEachBallWhereItIsSeen_data()
{
    QTest::addColumn<int>("poses");
    QTest::addColumn<int>("geometries");
    QTest::addColumn<uint>("seed");
    QTest::newRow("many heads") << 12 << 2 << 11U;
    QTest::newRow("many displays") << 2 << 12 << 12U;
}

void TestRenderCommand::drawsEachBallWhereItIsSeen()
{
    QFETCH(int, poses);
    QFETCH(int, geometries);
    QFETCH(uint, seed);
    if (!graphicsDriver())
        QSKIP("no OpenGL 3.3");
    const auto patient = builtinPatient(BuiltinPatient::TwelveYears);
    const auto errors = lab::checkGeometry(patient.value().landmarks, {poses, geometries, seed});
    QVERIFY2(errors.has_value(), errors ? "" : errors.error().detail.c_str());
    qInfo("%d measured, at most %.3f px off", errors->measured, errors->largest_px);
    QCOMPARE(errors->notDrawn, 0);
    QVERIFY(errors->largest_px <= kProjectionTolerance_px);
    const int all = 2 * static_cast<int>(lab::kBallColors) * poses * geometries;
    QCOMPARE(errors->measured + errors->outside + errors->touching, all);
    QVERIFY(errors->measured > all / 2);
}

void TestRenderCommand::drawsWhatTheSeedSays()
{
    const AirwayLandmarks airway = builtinPatient(BuiltinPatient::TwelveYears)->landmarks;
    const auto first = lab::HeadsetSeries::of(airway, {3, 2, 5}).value();
    const auto again = lab::HeadsetSeries::of(airway, {3, 2, 5}).value();
    const auto other = lab::HeadsetSeries::of(airway, {3, 2, 6}).value();
    QCOMPARE(first.size(), std::size_t{6});
    for (std::size_t i = 0; i < first.size(); ++i) {
        QVERIFY(first.head(i).translation() == again.head(i).translation());
        QVERIFY(first.display(i).p_HDl == again.display(i).p_HDl);
        QVERIFY(first.head(i).translation() != other.head(i).translation());
        QVERIFY(first.display(i).p_HDl != other.display(i).p_HDl);
    }
    QVERIFY(first.head(0).translation() == first.head(1).translation());
    QVERIFY(first.head(1).translation() != first.head(2).translation());
    QVERIFY(first.display(0).p_HDl == first.display(2).p_HDl);
    QVERIFY(first.display(0).p_HDl != first.display(1).p_HDl);
}

// A preset that is added is to be listed in the help, too.
void TestRenderCommand::listsEveryPreset()
{
    for (const AirwayPreset& preset : airwayPresets())
        QVERIFY2(std::string_view{lab::kPreset.help}.find(preset.name) != std::string_view::npos,
                 preset.name.data());
}

void TestRenderCommand::refusesWhatItDoesNotKnow_data()
{
    QTest::addColumn<QString>("words");
    QTest::addColumn<QString>("mention");
    const auto row = [](const char* name, const char* words, const char* mention) {
        QTest::newRow(name) << QString::fromLatin1(words) << QString::fromLatin1(mention);
    };
    row("nothing", "", "--check-geometry");
    row("a seed alone", "--seed 3", "--check-geometry");
    row("a flag there is not", "--check-geometry --fast", "--check-geometry");
    row("a word too many", "--check-geometry 3", "--check-geometry");
    row("a seed that is no number", "--check-geometry --seed some", "--seed");
    row("a seed below zero", "--check-geometry --seed -1", "--seed");
    row("both at once", "--check-geometry --pictures .", "--pictures DIR");
    row("a seed for pictures", "--pictures . --seed 1", "--pictures DIR");
    row("pictures without a folder", "--pictures", "--pictures DIR");
    row("a size that is none", "--pictures . --size big", "--size");
    row("a condition there is not", "--pictures . --condition cold", "--condition cold");
    row("a severity of nothing", "--pictures . --severity 0.5", "--condition");
    row("a side of nothing", "--pictures . --side left", "--condition");
    row("a ventilator there is not", "--pictures . --ventilator iron", "none, volume, pressure");
    row("more than severe", "--pictures . --condition copd --severity 1.1", "--severity");
    row("a patient there is not", "--pictures . --patient giant", "a patient is adult");
    row("a mouth too wide", "--pictures . --jaw-deg 31", "--jaw-deg");
    row("a jaw too far forward", "--pictures . --jaw-forward-mm far", "--jaw-forward-mm");
    row("a blade there is not", "--laryngoscopy . --blade spoon", "macintosh-3");
    row("an eye there is not", "--laryngoscopy . --from above", "video, direct");
    row("too high a lift", "--laryngoscopy . --lift-mm 31", "--lift-mm");
    row("too much levering", "--laryngoscopy . --levering-deg 31", "--levering-deg");
    row("a lift and levering", "--laryngoscopy . --lift-mm 9 --levering-deg 9", "not both");
    row("an event there is not", "--laryngoscopy . --event cough",
        "tongue_oedema, pharyngeal_swelling, epiglottitis, laryngeal_oedema, laryngospasm, "
        "floppy_epiglottis, anterior_larynx, angio_oedema, laryngeal_web, external_pressure, "
        "tracheal_stenosis, tracheal_deviation, goitre, neck_obesity, prominent_incisors, trismus, "
        "stiff_neck, burn, secretions, blood, vomit, foreign_body, fragile_teeth, "
        "swallowing");
    row("an event twice", "--laryngoscopy . --event epiglottitis --event epiglottitis=0.5", "once");
    row("an event too severe", "--laryngoscopy . --event epiglottitis=1.5", "0 to 1");
    row("a severity that is none", "--laryngoscopy . --event epiglottitis=", "0 to 1");
    row("events too severe", "--laryngoscopy . --event epiglottitis --severity 2", "--severity");
    row("a severity of no event", "--laryngoscopy . --severity 0.5", "--event");
    row("a preset there is not", "--laryngoscopy . --preset cough",
        "clear, cormack_lehane_1, cormack_lehane_2, cormack_lehane_3, cormack_lehane_4, "
        "swollen_mouth, anaphylaxis, swollen_lips, angio_oedema, acute_epiglottitis, burn, "
        "anterior_floppy, spasm, web, anterior_pressed, obese, pregnant, trauma_collar, goitre, "
        "after_tracheostomy, overjet");
    row("a preset and an event", "--laryngoscopy . --preset burn --event blood", "not both");
    row("a preset for pairs", "--event-pairs . --preset burn", "--event-pairs DIR");
    row("a condition in a laryngoscopy", "--laryngoscopy . --condition copd", "--laryngoscopy DIR");
    row("no draws", "--preset-grades --draws 0", "--draws");
    row("a blade there is not, for presets", "--preset-grades --blade spoon", "macintosh-3");
    row("events for presets", "--preset-grades --event burn", "--preset-grades");
    row("pairs too severe", "--event-pairs . --severity 2", "--severity");
    row("pairs of an event there is not", "--event-pairs . --event cough", "tongue_oedema");
    row("a lift for pairs", "--event-pairs . --lift-mm 3", "--event-pairs DIR");
    row("a folder nobody can make", "--pictures /proc/none", "/proc/none");
}

void TestRenderCommand::refusesWhatItDoesNotKnow()
{
    QFETCH(QString, words);
    QFETCH(QString, mention);
    const Result<QJsonObject> object =
        lab::renderCommand().run(words.split(QLatin1Char(' '), Qt::SkipEmptyParts));
    QVERIFY(!object);
    QVERIFY2(QString::fromStdString(object.error().detail).contains(mention),
             object.error().detail.c_str());
}

CARINA_SCREEN_TEST(TestRenderCommand)

} // namespace carina::render_command_test

#include "tst_render_command.moc"
