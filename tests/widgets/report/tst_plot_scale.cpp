#include "tests/support/test_class.h"
#include "widgets/report/plot_scale.h"

#include <QStringList>

#include <cmath>

namespace carina::plot_scale_test
{
namespace
{

constexpr double kRoundingError = 1e-12;

QStringList labelsOf(const PlotScale& scale)
{
    QStringList labels;
    for (const PlotScale::Tick& tick : scale.ticks())
        labels.append(tick.label);
    return labels;
}

bool isAt(double a, double b) { return std::abs(a - b) < kRoundingError; }

} // namespace

class PlotScaleTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void linearEndsAreRound_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("greatest");
        QTest::addColumn<QStringList>("labels");
        const auto row = [](const char* name, double least, double greatest, const char* labels) {
            QTest::newRow(name) << least << greatest
                                << QString::fromLatin1(labels).split(QLatin1Char{' '});
        };
        row("actions", 1.0, 50.0, "0 10 20 30 40 50");
        row("participants", 2.0, 6.0, "2 3 4 5 6");
        row("small", 0.0, 0.03, "0.000 0.005 0.010 0.015 0.020 0.025 0.030");
        row("both signs", -1.0, 4.0, "-1 0 1 2 3 4");
        row("below zero", -4.0, -0.5, "-4 -3 -2 -1 0");
        row("one number", 3.0, 3.0, "3.0 3.5 4.0 4.5 5.0 5.5 6.0");
        row("nothing but zero", 0.0, 0.0, "0.0 0.2 0.4 0.6 0.8 1.0");
    }
    void linearEndsAreRound()
    {
        QFETCH(double, least);
        QFETCH(double, greatest);
        QFETCH(QStringList, labels);
        const PlotScale scale = PlotScale::linear(least, greatest);
        QCOMPARE(labelsOf(scale), labels);
        QVERIFY(isAt(scale.least(), labels.front().toDouble()));
        QVERIFY(isAt(scale.greatest(), labels.back().toDouble()));
        QVERIFY(isAt(scale.placeOf(scale.least()), 0.0));
        QVERIFY(isAt(scale.placeOf(scale.greatest()), 1.0));
        QVERIFY(isAt(scale.placeOf(0.5 * (scale.least() + scale.greatest())), 0.5));
    }

    void logarithmicEndsAreDecades_data()
    {
        QTest::addColumn<double>("least");
        QTest::addColumn<double>("greatest");
        QTest::addColumn<QStringList>("labels"); // less the empty ones
        QTest::newRow("written out")
            << 0.2 << 200.0
            << QStringList{QStringLiteral("0.1"), QStringLiteral("1"), QStringLiteral("10"),
                           QStringLiteral("100"), QStringLiteral("1000")};
        QTest::newRow("decades as they are")
            << 0.01 << 1.0
            << QStringList{QStringLiteral("0.01"), QStringLiteral("0.1"), QStringLiteral("1")};
        QTest::newRow("as powers")
            << 2e-5 << 5e-4
            << QStringList{QStringLiteral("10⁻⁵"), QStringLiteral("10⁻⁴"), QStringLiteral("10⁻³")};
        QTest::newRow("one number")
            << 10.0 << 10.0 << QStringList{QStringLiteral("10"), QStringLiteral("100")};
    }
    void logarithmicEndsAreDecades()
    {
        QFETCH(double, least);
        QFETCH(double, greatest);
        QFETCH(QStringList, labels);
        const PlotScale scale = PlotScale::logarithmic(least, greatest);
        QStringList shown = labelsOf(scale);
        const auto decades = labels.size() - 1;
        QCOMPARE(shown.size(), labels.size() + 8 * decades); // 2 to 9 between
        shown.removeAll(QString{});
        QCOMPARE(shown, labels);
        QVERIFY(isAt(scale.placeOf(scale.least()), 0.0));
        QVERIFY(isAt(scale.placeOf(scale.greatest()), 1.0));
        QVERIFY(isAt(scale.placeOf(10.0 * scale.least()), 1.0 / double(decades)));
    }

    void manyDecadesHaveNothingBetween()
    {
        QCOMPARE(PlotScale::logarithmic(1e-6, 10.0).ticks().size(), std::size_t{8});
    }

    void logarithmicShowsOnlyWhatIsAboveZero()
    {
        const PlotScale scale = PlotScale::logarithmic(1.0, 10.0);
        QVERIFY(scale.shows(1e-9));
        QVERIFY(!scale.shows(0.0));
        QVERIFY(!scale.shows(-1.0));
        QVERIFY(PlotScale::linear(0.0, 1.0).shows(-1.0));
        QVERIFY(!PlotScale::linear(0.0, 1.0).shows(std::nan("")));
    }
};

CARINA_TEST(PlotScaleTest)

} // namespace carina::plot_scale_test

#include "tst_plot_scale.moc"
