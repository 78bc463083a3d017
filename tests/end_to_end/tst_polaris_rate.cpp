#include "tests/end_to_end/program.h"
#include "tests/support/test_class.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>

namespace carina::polaris_rate_test
{
namespace
{

constexpr double kRate_Hz = 59.0;

} // namespace

/// The rate at which three tools of a Polaris are read, at a serial port and over TCP, what that
/// costs, and how soon they are tracked again. The bounds are those of `carina-lab polaris-rate`.
class TestPolarisRate : public QObject
{
    Q_OBJECT

private Q_SLOTS:
    void initTestCase()
    {
        QProcess lab;
        lab.setProcessChannelMode(QProcess::ForwardedErrorChannel);
        lab.start(QStringLiteral(CARINA_LAB), {QStringLiteral("polaris-rate")});
        QVERIFY(lab.waitForFinished(kPatience_ms));
        m_printed = lab.readAllStandardOutput();
        m_measured = QJsonDocument::fromJson(m_printed).object();
        m_exitCode = lab.exitCode();
    }

    void threeToolsKeepTheirRate_data()
    {
        QTest::addColumn<QString>("part");
        QTest::addColumn<double>("core_percent");
        QTest::newRow("at a serial port") << "all_seen" << 3.0;
        QTest::newRow("at a serial port, one of them hidden") << "one_hidden" << 3.0;
        QTest::newRow("over TCP") << "network" << 10.0;
    }

    void threeToolsKeepTheirRate()
    {
        QFETCH(const QString, part);
        QFETCH(const double, core_percent);
        const QJsonObject measured = m_measured[part].toObject();
        const double rate = measured[QLatin1StringView{"samples_per_s"}].toDouble();
        QVERIFY2(rate >= kRate_Hz, m_printed.constData());
        const double client = measured[QLatin1StringView{"client_core_percent"}].toDouble();
        QVERIFY2(client > 0.0 && client < core_percent, m_printed.constData());
    }

    void holdsItsBounds()
    {
        QVERIFY2(m_measured[QLatin1StringView{"acceptable"}].toBool(), m_printed.constData());
        QCOMPARE(m_exitCode, 0);
    }

private:
    QByteArray m_printed;
    QJsonObject m_measured;
    int m_exitCode = 0;
};

CARINA_TEST(TestPolarisRate)

} // namespace carina::polaris_rate_test

#include "tst_polaris_rate.moc"
