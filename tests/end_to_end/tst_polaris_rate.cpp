#include "tests/support/test_class.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

namespace carina::polaris_rate_test
{
namespace
{

constexpr int kPatience_ms = 120'000;

} // namespace

/// The rate at which three tools of a Polaris are read, what that costs, and how soon they are
/// tracked again. The bounds are those of `carina-lab polaris-rate`.
class TestPolarisRate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void holdsItsBounds()
    {
        QProcess lab;
        lab.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        lab.start(QStringLiteral(CARINA_LAB), {QStringLiteral("polaris-rate")});
        QVERIFY(lab.waitForFinished(kPatience_ms));
        const QByteArray printed = lab.readAllStandardOutput();
        const QJsonObject measured = QJsonDocument::fromJson(printed).object();
        QVERIFY2(measured[QLatin1StringView{"acceptable"}].toBool(), printed.constData());
        QCOMPARE(lab.exitCode(), 0);
    }
};

CARINA_TEST(TestPolarisRate)

} // namespace carina::polaris_rate_test

#include "tst_polaris_rate.moc"
