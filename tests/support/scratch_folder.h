#pragma once

#include <QByteArrayView>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

namespace carina::test
{

/// A folder for the files that a test writes; it goes with them when the test is over.
class ScratchFolder
{
public:
    [[nodiscard]] QString path() const { return m_folder.path(); }

    /// Where a file is or would be.
    /// @param name may begin with folders
    [[nodiscard]] QString filePath(const char* name) const
    {
        return m_folder.filePath(QString::fromLatin1(name));
    }

    /// Makes a file of these bytes, and the folders it is in.
    /// @returns where it is
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
