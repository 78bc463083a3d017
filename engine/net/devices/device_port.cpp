#include "engine/net/devices/device_port.h"

#include "engine/net/devices/keep_alive.h"

#include <QDeadlineTimer>
#include <QSerialPort>
#include <QTcpSocket>
#include <QTimer>

namespace carina
{
namespace
{

constexpr int kBreak_ms = 300;                         // long enough for a Polaris at any rate
constexpr std::chrono::milliseconds kConnecting{2000}; // what is off refuses nothing

class SerialPort : public DevicePort
{
public:
    SerialPort(const std::string& path, Callbacks callbacks) : m_callbacks{std::move(callbacks)}
    {
        m_port.setPortName(QString::fromStdString(path));
        m_break.setSingleShot(true);
        QObject::connect(&m_break, &QTimer::timeout, &m_port,
                         [this] { m_port.setBreakEnabled(false); });
        QObject::connect(&m_port, &QIODevice::readyRead, &m_port, m_callbacks.arrived);
        QObject::connect(&m_port, &QSerialPort::errorOccurred, &m_port,
                         [this](QSerialPort::SerialPortError error) {
                             if (error == QSerialPort::ResourceError) // it was unplugged
                                 m_callbacks.closed(m_port.errorString().toStdString());
                         });
    }

    void open() override
    {
        if (m_port.open(QIODevice::ReadWrite))
            m_callbacks.opened();
        else
            m_callbacks.closed(m_port.errorString().toStdString());
    }
    void close() override
    {
        m_break.stop();
        m_port.close();
    }
    [[nodiscard]] bool isOpen() const override { return m_port.isOpen(); }
    [[nodiscard]] bool holdsRate(int rate) override
    {
        const qint32 present = m_port.baudRate();
        const bool holds = m_port.setBaudRate(rate);
        m_port.setBaudRate(present);
        return holds;
    }
    void act(const NdiPortAction& action) override
    {
        if (action.rate)
            m_port.setBaudRate(*action.rate);
        if (action.sendBreak && m_port.setBreakEnabled(true))
            m_break.start(kBreak_ms);
        if (action.bytes.empty())
            return;
        m_port.write(action.bytes.data(), qint64(action.bytes.size()));
        m_port.flush(); // at once, and not when the event loop finds that it can be written to
    }
    [[nodiscard]] QByteArray readAll() override { return m_port.readAll(); }

private:
    [[nodiscard]] QIODevice& line() override { return m_port; }

    Callbacks m_callbacks;
    QSerialPort m_port;
    QTimer m_break;
};

class TcpPort : public DevicePort
{
public:
    TcpPort(QString host, std::uint16_t port, Callbacks callbacks)
        : m_host{std::move(host)}, m_port{port}, m_callbacks{std::move(callbacks)}
    {
        m_connecting.setSingleShot(true);
        QObject::connect(&m_connecting, &QTimer::timeout, &m_socket, [this] {
            m_socket.abort();
            m_callbacks.closed("it does not answer");
        });
        QObject::connect(&m_socket, &QTcpSocket::connected, &m_socket, [this] {
            m_connecting.stop();
            m_socket.setSocketOption(QAbstractSocket::LowDelayOption, 1);
            keepAlive(m_socket);
            m_callbacks.opened();
        });
        QObject::connect(&m_socket, &QIODevice::readyRead, &m_socket, m_callbacks.arrived);
        QObject::connect(&m_socket, &QAbstractSocket::errorOccurred, &m_socket,
                         [this] { m_callbacks.closed(m_socket.errorString().toStdString()); });
    }

    void open() override
    {
        m_connecting.start(kConnecting);
        m_socket.connectToHost(m_host, m_port);
    }
    void close() override
    {
        m_connecting.stop();
        m_socket.abort();
    }
    [[nodiscard]] bool isOpen() const override
    {
        return m_socket.state() == QAbstractSocket::ConnectedState;
    }
    [[nodiscard]] bool holdsRate(int) override { return true; }
    void act(const NdiPortAction& action) override
    {
        if (action.bytes.empty())
            return;
        m_socket.write(action.bytes.data(), qint64(action.bytes.size()));
        m_socket.flush(); // as above
    }
    [[nodiscard]] QByteArray readAll() override { return m_socket.readAll(); }

private:
    [[nodiscard]] QIODevice& line() override { return m_socket; }

    QString m_host;
    std::uint16_t m_port;
    Callbacks m_callbacks;
    QTcpSocket m_socket;
    QTimer m_connecting;
};

} // namespace

void DevicePort::flush(std::chrono::milliseconds patience)
{
    const QDeadlineTimer end{patience};
    while (line().bytesToWrite() > 0 && line().waitForBytesWritten(int(end.remainingTime()))) {}
}

void DevicePort::await(std::chrono::milliseconds patience)
{
    if (line().bytesAvailable() == 0)
        static_cast<void>(line().waitForReadyRead(int(patience.count())));
}

bool isSerialPort(const std::string& address) { return address.starts_with('/'); }

bool isDeviceAddress(const std::string& address)
{
    return DevicePort::make(address, {[] {}, [] {}, [](const auto&) {}}).has_value();
}

Result<std::unique_ptr<DevicePort>> DevicePort::make(const std::string& address,
                                                     Callbacks callbacks)
{
    if (isSerialPort(address))
        return std::make_unique<SerialPort>(address, std::move(callbacks));
    const QString text = QString::fromStdString(address);
    const qsizetype colon = text.lastIndexOf(QLatin1Char{':'});
    bool isNumber = false;
    const int port = text.mid(colon + 1).toInt(&isNumber);
    if (colon < 1 || !isNumber || port < 1 || port > 0xFFFF)
        return fail(Errc::WrongAddress, address);
    return std::make_unique<TcpPort>(text.left(colon), std::uint16_t(port), std::move(callbacks));
}

} // namespace carina
