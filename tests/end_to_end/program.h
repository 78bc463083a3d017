#pragma once

#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QProcess>
#include <QTest>

#include <memory>
#include <vector>

/// For programs to make a patient and to show something, on a busy machine.
inline constexpr int kPatience_ms = 120'000;

/// For the session of a test, beside others that run at the same time, and below the ports that a
/// system hands out by itself.
inline QString portOfThisTest()
{
    return QString::number(20'000 + QCoreApplication::applicationPid() % 12'000);
}

/// One of the programs, with the journal of what it shows.
class Program
{
public:
    Program(QString path, QStringList arguments, QString journal)
        : m_path{std::move(path)}, m_arguments{std::move(arguments)}, m_journal{std::move(journal)}
    {
        m_arguments << QStringLiteral("--journal") << m_journal;
    }
    ~Program() { kill(); }

    /// With these variables from its next start on.
    void setEnvironment(const QProcessEnvironment& around) { m_around = around; }

    void start(const QStringList& more = {})
    {
        m_process = std::make_unique<QProcess>();
        m_process->setProcessChannelMode(QProcess::ForwardedChannels);
        m_process->setProcessEnvironment(m_around);
        m_process->start(m_path, m_arguments + more);
        QVERIFY2(m_process->waitForStarted(), qPrintable(m_path));
    }

    /// kill -9: no chance to say goodbye.
    void kill()
    {
        if (!m_process)
            return;
        m_process->kill();
        m_process->waitForFinished();
        m_process.reset();
        m_linesBefore = lines().size();
    }

    [[nodiscard]] bool hasEnded() const
    {
        return !m_process || m_process->state() == QProcess::NotRunning;
    }
    /// @pre it has ended by itself
    [[nodiscard]] int exitCode() const { return m_process->exitCode(); }

    /// What was shown last since the program was started; empty before anything was.
    [[nodiscard]] QJsonObject shown() const
    {
        const QByteArrayList all = lines();
        return all.size() > m_linesBefore ? QJsonDocument::fromJson(all.last()).object()
                                          : QJsonObject{};
    }

    /// And what was shown first.
    [[nodiscard]] QJsonObject shownFirst() const
    {
        return QJsonDocument::fromJson(lines().value(m_linesBefore)).object();
    }

    /// All that was shown since, oldest first.
    [[nodiscard]] std::vector<QJsonObject> allShown() const
    {
        std::vector<QJsonObject> all;
        for (const QByteArray& line : lines().mid(m_linesBefore))
            all.push_back(QJsonDocument::fromJson(line).object());
        return all;
    }

private:
    [[nodiscard]] QByteArrayList lines() const
    {
        QFile file{m_journal};
        if (!file.open(QIODevice::ReadOnly))
            return {};
        QByteArrayList all = file.readAll().split('\n');
        all.removeLast(); // what follows the last line's end, or half a line
        return all;
    }

    QString m_path;
    QStringList m_arguments;
    QString m_journal;
    QProcessEnvironment m_around = QProcessEnvironment::systemEnvironment();
    std::unique_ptr<QProcess> m_process;
    qsizetype m_linesBefore = 0;
};
