#include "evaluation/drift/polynomial_fit.h"
#include "tests/support/test_class.h"

#include <array>
#include <cmath>
#include <limits>

namespace carina::polynomial_fit_test
{
namespace
{

std::vector<double> upTo(int last)
{
    std::vector<double> x;
    for (int i = 0; i <= last; ++i)
        x.push_back(i);
    return x;
}

std::vector<double> valuesOf(const Polynomial& polynomial, const std::vector<double>& x)
{
    std::vector<double> y;
    for (const double value : x)
        y.push_back(polynomial.at(value));
    return y;
}

/// Greatest relative error of the coefficients.
double errorOf(const Polynomial& fitted, const std::vector<double>& truth)
{
    if (fitted.coefficients.size() != truth.size())
        return std::numeric_limits<double>::infinity();
    double error = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i)
        error = std::max(error, std::abs(fitted.coefficients[i] / truth[i] - 1.0));
    return error;
}

// Data set Norris of NIST's Statistical Reference Datasets: ozone monitors, y against x.
constexpr std::array kNorrisY{0.1,   338.8, 118.1, 888.0, 9.2,   228.1, 668.5, 998.5, 449.1,
                              778.9, 559.2, 0.3,   0.1,   778.1, 668.8, 339.3, 448.9, 10.8,
                              557.7, 228.3, 998.0, 888.8, 119.6, 0.3,   0.6,   557.6, 339.3,
                              888.0, 998.5, 778.9, 10.2,  117.6, 228.9, 668.4, 449.2, 0.2};
constexpr std::array kNorrisX{0.2,   337.4, 118.2, 884.6, 10.1,  226.5, 666.3, 996.3, 448.6,
                              777.0, 558.2, 0.4,   0.6,   775.5, 666.9, 338.0, 447.5, 11.6,
                              556.0, 228.1, 995.8, 887.6, 120.2, 0.3,   0.3,   556.8, 339.1,
                              887.2, 999.0, 779.0, 11.1,  118.3, 229.2, 669.1, 448.9, 0.5};

constexpr double kRelativeError = 1e-9;

} // namespace

class PolynomialFitTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void hasNistsCertifiedCoefficients_data()
    {
        QTest::addColumn<std::vector<double>>("x");
        QTest::addColumn<std::vector<double>>("y");
        QTest::addColumn<std::vector<double>>("certified");
        QTest::newRow("Norris") << std::vector<double>{kNorrisX.begin(), kNorrisX.end()}
                                << std::vector<double>{kNorrisY.begin(), kNorrisY.end()}
                                << std::vector<double>{-0.262323073774029, 1.00211681802045};
        const std::vector<double> ones(6, 1.0);
        QTest::newRow("Wampler1") << upTo(20) << valuesOf({ones}, upTo(20)) << ones;
        const std::vector<double> tenths{1.0, 0.1, 0.01, 0.001, 0.0001, 0.00001};
        QTest::newRow("Wampler2") << upTo(20) << valuesOf({tenths}, upTo(20)) << tenths;
    }
    void hasNistsCertifiedCoefficients()
    {
        QFETCH(std::vector<double>, x);
        QFETCH(std::vector<double>, y);
        QFETCH(std::vector<double>, certified);
        const auto fitted = fitPolynomial(x, y, static_cast<int>(certified.size()) - 1);
        QVERIFY(fitted);
        QVERIFY(errorOf(*fitted, certified) < kRelativeError);
    }

    void goesThroughAsManyPointsAsItHasCoefficients()
    {
        const std::vector<double> x{1.0, 2.0, 4.0, 8.0};
        const std::vector<double> y{3.0, -1.0, 0.5, 7.0};
        const auto fitted = fitPolynomial(x, y, 3);
        for (std::size_t i = 0; i < x.size(); ++i)
            QVERIFY(std::abs(fitted->at(x[i]) - y[i]) < kRelativeError);
    }

    void isTheMeanForOrderZero()
    {
        const std::vector<double> x{5.0, 5.0, 5.0};
        const std::vector<double> y{1.0, 2.0, 6.0};
        QVERIFY(std::abs(fitPolynomial(x, y, 0)->at(100.0) - 3.0) < kRelativeError);
    }

    void refusesWhatHasNoOneBestPolynomial_data()
    {
        QTest::addColumn<std::vector<double>>("x");
        QTest::addColumn<std::vector<double>>("y");
        QTest::addColumn<int>("code");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("no points")
            << std::vector<double>{} << std::vector<double>{} << int(Errc::OutOfRange);
        QTest::newRow("two at one place") << std::vector<double>{1.0, 1.0}
                                          << std::vector<double>{1.0, 2.0} << int(Errc::OutOfRange);
        QTest::newRow("no number") << std::vector<double>{1.0, 2.0} << std::vector<double>{1.0, nan}
                                   << int(Errc::NotFinite);
        QTest::newRow("at no number") << std::vector<double>{nan, 2.0}
                                      << std::vector<double>{1.0, 1.0} << int(Errc::NotFinite);
    }
    void refusesWhatHasNoOneBestPolynomial()
    {
        QFETCH(std::vector<double>, x);
        QFETCH(std::vector<double>, y);
        QFETCH(int, code);
        const auto fitted = fitPolynomial(x, y, 1);
        QVERIFY(!fitted);
        QCOMPARE(int(fitted.error().code), code);
    }
};

CARINA_TEST(PolynomialFitTest)

} // namespace carina::polynomial_fit_test

#include "tst_polynomial_fit.moc"
