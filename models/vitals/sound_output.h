#pragma once

#include <QAudioFormat>
#include <QMediaDevices>
#include <QObject>
#include <QString>
#include <QTimer>

#include <functional>
#include <memory>
#include <span>

class QAudioSink;
class QIODevice;

namespace carina
{

/// Plays computed samples at this computer's usual audio device, and goes to another one when that
/// changes. Where there is none, or it fails, the program goes on without sound, and obstacle()
/// says so.
class SoundOutput : public QObject
{
    Q_OBJECT

public:
    /// Fills in the next samples, of one channel at kSoundRate.
    using Render = std::function<void(std::span<float>)>;

    /// @pre what render refers to outlives this
    explicit SoundOutput(Render render, QObject* parent = nullptr);
    ~SoundOutput() override;

    /// Why nothing is heard, and what to do about it; empty while it plays.
    [[nodiscard]] const QString& obstacle() const { return m_obstacle; }

Q_SIGNALS:
    /// It begins to play, or does not any more.
    void changed();

private:
    void open();
    void close();
    void say(const QString& obstacle);
    [[nodiscard]] QString tryToOpen();
    void follow();
    void feed();

    Render m_render;
    QMediaDevices m_devices;
    QAudioFormat m_format;
    std::unique_ptr<QAudioSink> m_sink;
    QIODevice* m_input = nullptr; ///< of the sink
    QTimer m_feeding;
    QString m_obstacle;
};

} // namespace carina
