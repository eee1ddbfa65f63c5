#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace topology {

/// Which rows of a table are dead. It costs nothing until the first one dies.
class DeadRows {
public:
    bool contains(std::uint32_t row) const
    {
        const std::size_t word = row / word_bits;
        return word < words_.size() && (words_[word] >> (row % word_bits) & 1U) != 0;
    }
    void add(std::uint32_t row)
    {
        if (row / word_bits >= words_.size()) words_.resize(row / word_bits + 1, 0);
        words_[row / word_bits] |= std::uint64_t{1} << (row % word_bits);
        ++count_;
    }
    void remove(std::uint32_t row)
    {
        words_[row / word_bits] &= ~(std::uint64_t{1} << (row % word_bits));
        --count_;
        while (!words_.empty() && words_.back() == 0) words_.pop_back(); // equal sets are equal vectors
    }
    std::size_t count() const { return count_; }
    std::size_t bytes() const { return words_.capacity() * sizeof(std::uint64_t); }

    friend bool operator==(const DeadRows&, const DeadRows&) = default;

private:
    static constexpr std::uint32_t word_bits = 64;
    std::vector<std::uint64_t> words_;
    std::size_t count_ = 0;
};

/// The entities of one kind in a dense array. A dead entity keeps its row, and what the row says, so that it can come
/// back; its number is not given to another.
template <class Id, class Entity> class Table {
public:
    Id add(const Entity& entity)
    {
        if (rows_.size() >= most) throw std::length_error("a solid has room for 4 294 967 295 entities of a kind");
        rows_.push_back(entity);
        return Id{static_cast<std::uint32_t>(rows_.size() - 1)};
    }
    void undo_last() { rows_.pop_back(); } ///< undoes `add`
    void kill(Id id) { dead_.add(id.index); }
    void revive(Id id) { dead_.remove(id.index); }

    bool has(Id id) const { return id.index < rows_.size() && !dead_.contains(id.index); }
    std::size_t n_living() const { return rows_.size() - dead_.count(); }
    std::size_t n_rows() const { return rows_.size(); } ///< living and dead
    Id last() const { return Id{static_cast<std::uint32_t>(rows_.size() - 1)}; }

    Entity& operator[](Id id) { return rows_[id.index]; }
    const Entity& operator[](Id id) const { return rows_[id.index]; }

    void reserve(std::size_t rows) { rows_.reserve(rows); }
    std::size_t bytes() const { return rows_.capacity() * sizeof(Entity) + dead_.bytes(); }

    /// The living ones in the order in which they were made: for (VertexId v : table) ...
    class Iterator {
    public:
        Iterator(const Table& table, std::uint32_t row) : table_(&table), row_(row) { skip_dead(); }
        Id operator*() const { return Id{row_}; }
        Iterator& operator++()
        {
            ++row_;
            skip_dead();
            return *this;
        }
        friend bool operator==(const Iterator& a, const Iterator& b) { return a.row_ == b.row_; }

    private:
        void skip_dead()
        {
            while (row_ < table_->n_rows() && table_->dead_.contains(row_)) ++row_;
        }
        const Table* table_;
        std::uint32_t row_;
    };
    Iterator begin() const { return {*this, 0}; }
    Iterator end() const { return {*this, static_cast<std::uint32_t>(rows_.size())}; }

    friend bool operator==(const Table&, const Table&) = default;

private:
    static constexpr std::size_t most = std::numeric_limits<std::uint32_t>::max();
    std::vector<Entity> rows_;
    DeadRows dead_;
};

} // namespace topology
