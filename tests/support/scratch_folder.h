#pragma once

#include <QByteArrayView>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

namespace carina::test
{

/// A folder in memory, where the system has one: thousands of stores are opened in it.
inline QString fastFolder()
{
    const QString memory = QStringLiteral("/dev/shm");
    return (QFileInfo{memory}.isWritable() ? memory : QDir::tempPath())
           + QStringLiteral("/carina-XXXXXX");
}

/// A temporary folder for the files of a test; it is deleted with them at the end.
class ScratchFolder
{
public:
    [[nodiscard]] QString path() const { return m_folder.path(); }

    /// The path of a file, which need not exist.
    /// @param name relative path, may contain folders
    [[nodiscard]] QString filePath(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }

    /// Writes a file with these bytes, and creates its folders.
    /// @returns its path
    QString write(const char* name, QByteArrayView bytes) const
    {
        const QString path = filePath(name);
        QFile file{path};
        if (!QDir{}.mkpath(QFileInfo{path}.path()) || !file.open(QIODevice::WriteOnly)
            || file.write(bytes.data(), bytes.size()) != bytes.size())
            qFatal("a test file could not be written");
        return path;
    }

private:
    QTemporaryDir m_folder;
};

} // namespace carina::test
