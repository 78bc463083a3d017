#include "apps/lab/commands.h"
#include "tests/support/test_class.h"

#include <QJsonObject>

#include <array>

namespace carina::lab::polaris_rate_command_test
{

namespace
{

constexpr double kBack_s = 2.0; ///< from when a device is back until its tools are tracked
constexpr double kRate_Hz = 59.0;
constexpr double kCore_percent = 3.0;
constexpr double kNetworkCore_percent = 10.0;

/// A part of what was measured, and what is demanded of it.
struct Part {
    const char* key;
    double core_percent;
};
constexpr std::array kParts{Part{"all_seen", kCore_percent}, Part{"one_hidden", kCore_percent},
                            Part{"network", kNetworkCore_percent}};

} // namespace

class PolarisRateCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // Here other tests run beside it: end_to_end.polaris_rate demands that it is acceptable.
    void threeToolsKeepTheirRate()
    {
        const auto object =
            polarisRateCommand().run({QStringLiteral("--seconds"), QStringLiteral("2")});
        QVERIFY2(object, object ? "" : object.error().detail.c_str());
        QCOMPARE((*object)[QLatin1StringView{"bits_per_second"}].toInt(), 115200);
        QCOMPARE((*object)[QLatin1StringView{"poses"}].toString(), QStringLiteral("bx"));
        bool isFast = true;
        for (const Part& part : kParts) {
            const QJsonObject measured = (*object)[QLatin1StringView{part.key}].toObject();
            const double rate = measured[QLatin1StringView{"samples_per_s"}].toDouble();
            QVERIFY2(rate > 30.0 && rate < 61.5,
                     qPrintable(QLatin1StringView{part.key} + QStringLiteral(": %1").arg(rate)));
            const double client = measured[QLatin1StringView{"client_core_percent"}].toDouble();
            QVERIFY(client > 0.0);
            isFast = isFast && rate >= kRate_Hz && client < part.core_percent;
            QVERIFY(measured[QLatin1StringView{"device_core_percent"}].toDouble() > 0.0);
        }
        const double back = (*object)[QLatin1StringView{"back_s"}].toDouble();
        QVERIFY2(back > 0.0 && back < kBack_s, qPrintable(QString::number(back)));
        QCOMPARE((*object)[QLatin1StringView{"acceptable"}], QJsonValue{isFast});
    }

    void refusesOtherWords()
    {
        for (const QStringList& words : {QStringList{QStringLiteral("DIR")},
                                         {QStringLiteral("--poses"), QStringLiteral("gx")},
                                         {QStringLiteral("--seconds"), QStringLiteral("0")}}) {
            const auto object = polarisRateCommand().run(words);
            QVERIFY(!object);
            QCOMPARE(object.error().code, Errc::WrongOption);
        }
    }
};

CARINA_TEST(PolarisRateCommandTest)

} // namespace carina::lab::polaris_rate_command_test

#include "tst_polaris_rate_command.moc"
