#include "apps/lab/commands.h"
#include "tests/support/test_class.h"

#include <QJsonObject>

namespace carina::lab::polaris_rate_command_test
{

namespace
{

constexpr double kBack_s = 2.0; ///< from when a device is back until its tools are tracked

} // namespace

class PolarisRateCommandTest : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    // How much that costs is told by the command; here other tests run beside it.
    void threeToolsKeepTheirRateWhileOneIsHidden()
    {
        const auto object =
            polarisRateCommand().run({QStringLiteral("--seconds"), QStringLiteral("2")});
        QVERIFY2(object, object ? "" : object.error().detail.c_str());
        QCOMPARE((*object)[QLatin1StringView{"bits_per_second"}].toInt(), 115200);
        QCOMPARE((*object)[QLatin1StringView{"poses"}].toString(), QStringLiteral("bx"));
        for (const char* part : {"all_seen", "one_hidden"}) {
            const QJsonObject measured = (*object)[QLatin1StringView{part}].toObject();
            const double rate = measured[QLatin1StringView{"samples_per_s"}].toDouble();
            QVERIFY2(rate > 30.0 && rate < 61.5, qPrintable(QString::number(rate)));
            QVERIFY(measured[QLatin1StringView{"client_core_percent"}].toDouble() > 0.0);
            QVERIFY(measured[QLatin1StringView{"device_core_percent"}].toDouble() > 0.0);
        }
        const double back = (*object)[QLatin1StringView{"back_s"}].toDouble();
        QVERIFY2(back > 0.0 && back < kBack_s, qPrintable(QString::number(back)));
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
