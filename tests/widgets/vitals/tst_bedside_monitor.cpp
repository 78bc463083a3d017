#include "tests/support/test_class.h"
#include "widgets/vitals/bedside_monitor.h"

#include <QFontMetrics>
#include <QImage>
#include <QScreen>

#include <cmath>
#include <memory>

namespace carina::bedside_monitor_test
{
namespace
{

using Row = BedsideMonitor::Row;
using Urgency = BedsideMonitor::Urgency;

/// How near a pixel's colour comes to what it is painted in, with smooth edges: of 255.
constexpr int kSameColour = 40;
constexpr int kRounded = 10;       ///< pixels at the ends of lines that are painted in pieces
constexpr int kLeastReadable = 14; ///< pixels: 10 points at 96 dots per inch

std::unique_ptr<BedsideMonitor> monitor(QSize size)
{
    auto made = std::make_unique<BedsideMonitor>();
    QPalette palette;
    palette.setColor(QPalette::Base, Qt::black);
    palette.setColor(QPalette::Text, Qt::white);
    palette.setColor(QPalette::Mid, Qt::darkGray);
    made->setPalette(palette);
    made->resize(size);
    made->setNumbers({.heartRate_perMin = 100,
                      .saturation_percent = 100,
                      .endTidalCO2_mmHg = 38,
                      .respiratoryRate_perMin = 14,
                      .pressure = BedsideMonitor::BloodPressure{121, 78, 92}});
    return made;
}

bool isLike(QColor a, QColor b)
{
    return std::abs(a.red() - b.red()) < kSameColour
           && std::abs(a.green() - b.green()) < kSameColour
           && std::abs(a.blue() - b.blue()) < kSameColour;
}

/// How many pixels of a part of a picture have a colour.
int pixelsOf(const QImage& image, const QRectF& part, QColor colour)
{
    int count = 0;
    const QRect within = part.toAlignedRect().intersected(image.rect());
    for (int y = within.top(); y <= within.bottom(); ++y)
        for (int x = within.left(); x <= within.right(); ++x)
            count += isLike(image.pixelColor(x, y), colour) ? 1 : 0;
    return count;
}

/// How many pixels differ. @pre both have the same size
int pixelsApart(const QImage& a, const QImage& b)
{
    int count = 0;
    for (int y = 0; y < a.height(); ++y)
        for (int x = 0; x < a.width(); ++x)
            count += isLike(a.pixelColor(x, y), b.pixelColor(x, y)) ? 0 : 1;
    return count;
}

/// Whether a bright line goes down a frame at x, which may lie between two columns of pixels.
bool isLineAt(const QImage& image, double x, const QRectF& frame)
{
    constexpr int kBright = 180; // of 255, in all columns that it touches
    int rows = 0;
    for (int y = int(frame.top()) + 2; y < int(frame.bottom()) - 2; ++y) {
        int brightness = 0;
        for (int column = int(x) - 1; column <= int(x) + 1; ++column)
            brightness += image.pixelColor(column, y).red();
        rows += brightness > kBright ? 1 : 0;
    }
    return rows > 0.9 * (frame.height() - 4.0);
}

void nameSizes()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("least") << BedsideMonitor::kLeast;
    QTest::newRow("a low panel") << QSize{400, 220};
    QTest::newRow("a panel") << QSize{430, 360};
    QTest::newRow("flat") << QSize{1200, 220};
    QTest::newRow("high") << QSize{300, 900};
    QTest::newRow("whole screen") << QSize{1920, 1080};
}

} // namespace

class TestBedsideMonitor : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void placesNothingUponAnother_data() { nameSizes(); }
    void placesNothingUponAnother()
    {
        QFETCH(QSize, size);
        const auto shown = monitor(size);
        shown->setSoundNote(QStringLiteral("■ Alarms silent"));
        const auto drawn = shown->drawing();
        std::vector<QRectF> places{drawn.alarm, drawn.respiratoryRate, drawn.pressure};
        for (const auto& strip : drawn.strips)
            places.insert(places.end(), {strip.frame, strip.label, strip.number});
        for (std::size_t i = 0; i < places.size(); ++i) {
            QVERIFY(QRectF{shown->rect()}.contains(places[i]));
            QVERIFY(places[i].width() > 0.0 && places[i].height() > 0.0);
            for (std::size_t j = 0; j < i; ++j) {
                const QRectF common = places[i].intersected(places[j]);
                QVERIFY(common.width() < 0.01 || common.height() < 0.01);
            }
        }
        QVERIFY(drawn.alarm.contains(drawn.soundNote));
    }

    /// Piece by piece beside the bar, through two sweeps, and all at once.
    void paintsWhatTheBarPassesAsItPaintsTheWhole()
    {
        constexpr double kEach_s = 0.05;
        constexpr int kSamples = 300;
        constexpr int kLookEach = 37;
        const auto shown = monitor({430, 360});
        shown->show();
        QVERIFY(QTest::qWaitForWindowExposed(shown.get()));
        for (int i = 0; i < kSamples; ++i) {
            const double t = kEach_s * i;
            const double wave = 0.5 + 0.5 * std::sin(3.0 * t);
            const auto breath = i % 80 < 50 ? std::optional{38.0 * wave} : std::nullopt;
            shown->add({t, wave, wave, breath});
            QCoreApplication::processEvents();
            if (i % kLookEach != 0)
                continue;
            const QImage pieces = shown->screen()->grabWindow(shown->winId()).toImage();
            const QImage whole = shown->grab().toImage();
            QCOMPARE(pieces.size(), whole.size());
            QVERIFY(pixelsApart(pieces, whole) <= kRounded);
        }
    }

    void isReadable_data() { nameSizes(); }
    void isReadable()
    {
        QFETCH(QSize, size);
        const auto shown = monitor(size);
        const auto drawn = shown->drawing();
        QVERIFY(drawn.labelPixels >= kLeastReadable);
        QVERIFY(drawn.lowerPixels >= kLeastReadable);
        QVERIFY(drawn.numberPixels >= 2 * drawn.labelPixels);
        QFont font = shown->font();
        font.setPixelSize(drawn.labelPixels);
        const QFontMetrics words{font};
        font.setPixelSize(drawn.numberPixels);
        const QFontMetrics figures{font};
        for (const auto& strip : drawn.strips) {
            QVERIFY(figures.horizontalAdvance(QStringLiteral("100")) <= strip.number.width());
            QVERIFY(figures.tightBoundingRect(QStringLiteral("100")).height()
                    <= strip.number.height());
            QVERIFY(strip.frame.width() > 1.5 * strip.number.width());
            QVERIFY(strip.frame.width() > 100.0 && strip.frame.height() > 35.0);
            QVERIFY(2.0 * words.height() <= strip.label.height());
            QVERIFY(words.horizontalAdvance(QStringLiteral("EtCO2")) <= strip.label.width());
            QVERIFY(words.horizontalAdvance(QStringLiteral("mmHg")) <= strip.label.width());
        }
        font.setPixelSize(drawn.lowerPixels);
        QVERIFY(QFontMetrics{font}.horizontalAdvance(QStringLiteral("BP 121/78 (92) mmHg"))
                <= drawn.pressure.width());
    }

    void drawsEachNumberInTheColourOfItsCurve_data() { nameSizes(); }
    void drawsEachNumberInTheColourOfItsCurve()
    {
        QFETCH(QSize, size);
        const auto shown = monitor(size);
        const QImage image = shown->grab().toImage();
        const auto drawn = shown->drawing();
        for (const Row row : {Row::Electrocardiogram, Row::Pulse, Row::Capnogram}) {
            const QRectF place = drawn.strips[std::size_t(row)].number;
            const int there = pixelsOf(image, place, BedsideMonitor::colourOf(row));
            // Three figures, each with a stroke at least as long as half its height.
            QVERIFY2(there > drawn.numberPixels, qPrintable(QString::number(there)));
        }
    }

    void drawsADashForWhatIsNotMeasured()
    {
        const auto shown = monitor({430, 360});
        const auto place = shown->drawing().strips[std::size_t(Row::Pulse)].number;
        const QColor colour = BedsideMonitor::colourOf(Row::Pulse);
        const int before = pixelsOf(shown->grab().toImage(), place, colour);
        shown->setNumbers({});
        const int dash = pixelsOf(shown->grab().toImage(), place, colour);
        QVERIFY(dash > 0 && dash < before / 3);
    }

    void writesTheCurvesBehindABar()
    {
        const auto shown = monitor({640, 480});
        // Flat curves at known heights: the middle of each scale.
        for (int i = 0; i <= 300; ++i)
            shown->add({0.01 * i, 0.5, 0.5, 30.0});
        const auto drawn = shown->drawing();
        const QImage image = shown->grab().toImage();
        for (const Row row : {Row::Electrocardiogram, Row::Pulse, Row::Capnogram}) {
            const auto& strip = drawn.strips[std::size_t(row)];
            const double sweep_s =
                row == Row::Capnogram ? BedsideMonitor::kSlowSweep_s : BedsideMonitor::kFastSweep_s;
            const double bar = strip.frame.left() + 3.0 / sweep_s * strip.frame.width();
            QVERIFY(strip.bar && std::abs(*strip.bar - bar) < 1.0);
            const QColor colour = BedsideMonitor::colourOf(row);
            const double middle = strip.frame.center().y();
            const QRectF written{strip.frame.left() + 5.0, middle - 2.0, bar - 40.0, 4.0};
            QVERIFY(pixelsOf(image, written, colour) > 0.7 * written.width());
            const QRectF ahead{bar + 5.0, strip.frame.top() + 20.0, strip.frame.right() - bar - 5.0,
                               strip.frame.height() - 30.0};
            QCOMPARE(pixelsOf(image, ahead, colour), 0);
            QVERIFY(isLineAt(image, bar, strip.frame));
        }
    }

    void movesNothingForAnAlarm()
    {
        const auto shown = monitor({430, 240});
        const auto before = shown->drawing();
        shown->setAlarms(
            {{Urgency::High, QStringLiteral("No heartbeat"), QStringLiteral("high priority")},
             {Urgency::Low, QStringLiteral("Oximeter probe off"), QStringLiteral("low priority")}});
        shown->setSoundNote(QStringLiteral("■ Muted"));
        const auto after = shown->drawing();
        QCOMPARE(after.respiratoryRate, before.respiratoryRate);
        for (std::size_t row = 0; row < BedsideMonitor::kRows; ++row) {
            QCOMPARE(after.strips[row].frame, before.strips[row].frame);
            QCOMPARE(after.strips[row].number, before.strips[row].number);
        }
    }

    void makesRoomForMuchCO2()
    {
        const auto shown = monitor({640, 480});
        shown->add({1.0, 0.0, 0.5, 80.0});
        const auto strip = shown->drawing().strips[std::size_t(Row::Capnogram)];
        const double up = (strip.frame.bottom() - strip.lines[0][0].y()) / strip.frame.height();
        QVERIFY(std::abs(up - 80.0 / BedsideMonitor::kMostCO2_mmHg) < 1e-6);
        shown->clear();
        QVERIFY(shown->drawing().strips[0].lines.empty());
    }

    void fillsTheAlarmLineByUrgency_data()
    {
        QTest::addColumn<int>("urgency");
        QTest::newRow("low") << int(Urgency::Low);
        QTest::newRow("medium") << int(Urgency::Medium);
        QTest::newRow("high") << int(Urgency::High);
    }

    void fillsTheAlarmLineByUrgency()
    {
        QFETCH(int, urgency);
        const auto shown = monitor({430, 360});
        const QRectF lines = shown->drawing().alarm;
        const QColor colour = BedsideMonitor::colourOf(Urgency(urgency));
        QVERIFY(pixelsOf(shown->grab().toImage(), lines, colour) < 0.1 * lines.width());
        shown->setAlarms(
            {{Urgency(urgency), QStringLiteral("SpO2 below 85 %"), QStringLiteral("priority")}});
        const int filled = pixelsOf(shown->grab().toImage(), lines, colour);
        QVERIFY(filled > 0.5 * lines.width() * lines.height());
    }

    // Three to one is what WCAG asks of large text and of marks, 4.5 of small text.
    void hasWordsThatContrast()
    {
        const auto luminance = [](QColor colour) {
            const auto linear = [](double c) {
                return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
            };
            return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF())
                   + 0.0722 * linear(colour.blueF());
        };
        const auto contrast = [&](QColor a, QColor b) {
            const double one = luminance(a) + 0.05;
            const double other = luminance(b) + 0.05;
            return std::max(one, other) / std::min(one, other);
        };
        QVERIFY(contrast(BedsideMonitor::colourOf(Urgency::High), Qt::white) > 4.5);
        QVERIFY(contrast(BedsideMonitor::colourOf(Urgency::Medium), Qt::black) > 4.5);
        QVERIFY(contrast(BedsideMonitor::colourOf(Urgency::Low), Qt::black) > 4.5);
        const QColor base{22, 29, 36}; // of the theme
        for (const Row row : {Row::Electrocardiogram, Row::Pulse, Row::Capnogram})
            QVERIFY(contrast(BedsideMonitor::colourOf(row), base) > 4.5);
    }

    void marksEachPulse()
    {
        const auto shown = monitor({430, 360});
        const QRectF mark = shown->drawing().pulseMark;
        const QColor colour = BedsideMonitor::colourOf(Row::Pulse);
        QCOMPARE(pixelsOf(shown->grab().toImage(), mark, colour), 0);
        shown->setPulse(true);
        QVERIFY(pixelsOf(shown->grab().toImage(), mark, colour) > 10);
    }

    void showsThatItIsMute()
    {
        const auto shown = monitor({430, 360});
        shown->setSoundNote(QStringLiteral("■ Alarms silent"));
        const QRectF note = shown->drawing().soundNote;
        QVERIFY(pixelsOf(shown->grab().toImage(), note, Qt::white) > 40);
        QVERIFY(shown->accessibleName().contains(QStringLiteral("Alarms silent")));
    }

    void saysItsValuesInWords()
    {
        const auto shown = monitor({430, 360});
        QCOMPARE(shown->accessibleName(),
                 QStringLiteral("Bedside monitor; heart rate 100 per minute; SpO2 100 per cent; "
                                "end-tidal CO2 38 mmHg; respiratory rate 14 per minute; blood "
                                "pressure 121 over 78, mean 92 mmHg"));
        shown->setNumbers({.saturation_percent = 84});
        shown->setAlarms(
            {{Urgency::High, QStringLiteral("SpO2 below 85 %"), QStringLiteral("high priority")}});
        QCOMPARE(shown->accessibleName(),
                 QStringLiteral("Bedside monitor; alarm of high priority: SpO2 below 85 %; SpO2 84 "
                                "per cent"));
    }
};

CARINA_SCREEN_TEST(TestBedsideMonitor)

} // namespace carina::bedside_monitor_test

#include "tst_bedside_monitor.moc"
