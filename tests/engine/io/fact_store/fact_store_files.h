#pragma once

#include "engine/io/fact_store/sql_fact_store.h"
#include "tests/support/scratch_folder.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

namespace carina::test
{

/// A fact unlike all others.
inline FactRecord numbered(std::uint64_t number)
{
    std::vector<std::byte> body(std::size_t(number % 40), std::byte(number & 0xff));
    return {FactNumber{number},
            ProposalId{0xffff'ffff'ffff'0000 + number},
            ParticipantId{std::uint16_t(0xffff - number)},
            StationId{std::uint16_t(number % 7)},
            SessionTime{Duration{1'000'000'000'000'000'000 + std::int64_t(number)}},
            SessionTime{Duration{-std::int64_t(number)}},
            std::move(body)};
}

inline std::unique_ptr<FactStore> opened(const std::filesystem::path& path)
{
    Result<std::unique_ptr<FactStore>> store = openFactStore(path);
    if (!store)
        qWarning("%s", store.error().detail.c_str());
    return store ? *std::move(store) : nullptr;
}

/// Appends one fact.
inline Result<void> append(FactStore& store, const FactRecord& fact)
{
    return store.append(std::span{&fact, 1});
}

inline Result<void> keepAction(FactStore& store, const EventCpo& event)
{
    return store.keepActions(std::span{&event, 1});
}

/// A closed store with so many facts.
inline void fill(const std::filesystem::path& path, std::uint64_t facts)
{
    const auto store = opened(path);
    for (std::uint64_t number = 1; number <= facts; ++number)
        QVERIFY(append(*store, numbered(number)));
}

/// Paths of files that do not exist yet, in a folder that goes with this object.
class FreshFiles
{
public:
    [[nodiscard]] std::filesystem::path next()
    {
        const QString name = QStringLiteral("session %1.carina").arg(++m_count);
        return QFile::encodeName(m_folder.filePath(name)).toStdString();
    }

private:
    QTemporaryDir m_folder{fastFolder()};
    int m_count = 0;
};

inline QByteArray bytesOf(const std::filesystem::path& path)
{
    QFile file{QFile::decodeName(path.c_str())};
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray{};
}

inline void write(const std::filesystem::path& path, const QByteArray& bytes)
{
    QFile file{QFile::decodeName(path.c_str())};
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(bytes), bytes.size());
}

} // namespace carina::test
